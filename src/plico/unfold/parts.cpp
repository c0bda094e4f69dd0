#include "plico/unfold/parts.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "plico/unfold/dual_tree.h"
#include "plico/unfold/overlap.h"

namespace plico {
namespace {

// Folds to cut, named by the panel below each.
class Cutting {
 public:
  explicit Cutting(const DualTree& tree) : tree_(tree), cut_(tree.mesh().num_faces(), 0) {}

  // Parts every overlapping pair, the deepest meeting first.
  void part_all() {
    struct Pair {
      int a, b, meeting_depth;
    };
    std::vector<Pair> pairs;
    for (int a : tree_.overlapping_panels())
      for (int b : tree_.overlapping(a))
        if (a < b) pairs.push_back({a, b, tree_.depth(meeting(a, b))});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      return std::tuple(-p.meeting_depth, p.a, p.b) < std::tuple(-q.meeting_depth, q.a, q.b);
    });
    for (const Pair& pair : pairs)
      if (!parted(pair.a, pair.b)) cut_below_meeting(pair.a, pair.b);
  }

  bool cut(int panel) const { return cut_[panel]; }

 private:
  int meeting(int a, int b) const {
    while (a != b) (tree_.depth(a) >= tree_.depth(b) ? a : b) = tree_.parent(tree_.depth(a) >= tree_.depth(b) ? a : b);
    return a;
  }
  bool parted(int a, int b) const {
    while (a != b) {
      int& lower = tree_.depth(a) >= tree_.depth(b) ? a : b;
      if (cut_[lower]) return true;
      lower = tree_.parent(lower);
    }
    return false;
  }
  // One cut on the side whose branch is smaller: that branch may fit elsewhere.
  void cut_below_meeting(int a, int b) {
    int below_a = -1, below_b = -1;
    while (a != b) {
      if (tree_.depth(a) >= tree_.depth(b)) {
        below_a = a;
        a = tree_.parent(a);
      } else {
        below_b = b;
        b = tree_.parent(b);
      }
    }
    if (below_a < 0) std::swap(below_a, below_b);
    if (below_b >= 0 && tree_.subtree_size(below_b) < tree_.subtree_size(below_a)) std::swap(below_a, below_b);
    cut_[below_a] = 1;
  }

  const DualTree& tree_;
  std::vector<char> cut_;
};

// Parts as they lie, each with its own grid; the smaller of two joined parts moves into the other's frame.
class Joining {
 public:
  Joining(const FlatFaces& faces, FoldForest forest, std::vector<Vec2> at)
      : faces_(faces),
        mesh_(faces.mesh()),
        forest_(std::move(forest)),
        at_(std::move(at)),
        part_(mesh_.num_faces(), -1) {
    for (FaceId f : mesh_.faces())
      if (part_[f] < 0) collect(f);
  }

  FoldForest run() {
    std::vector<int> order(panels_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return panels_[a].size() < panels_[b].size(); });
    for (int part : order) join_somewhere(part);
    return std::move(forest_);
  }

 private:
  void collect(FaceId first) {
    const int part = static_cast<int>(panels_.size());
    std::vector<int> panels{first};
    part_[first] = part;
    for (std::size_t i = 0; i < panels.size(); ++i) {
      for (HalfedgeId h : mesh_.halfedges(FaceId(panels[i]))) {
        if (!forest_.is_fold[mesh_.edge(h)]) continue;
        const FaceId next = mesh_.face(mesh_.twin(h));
        if (part_[next] >= 0) continue;
        part_[next] = part;
        panels.push_back(next);
      }
    }
    PanelGrid& grid = grids_.emplace_back(static_cast<int>(panels.size()), faces_.cell_size());
    for (int f : panels) grid.insert(f, box_of(corners(f), faces_.degree(f)));
    panels_.push_back(std::move(panels));
  }

  void join_somewhere(int part) {
    for (int panel : panels_[part]) {
      for (HalfedgeId h : mesh_.halfedges(FaceId(panel))) {
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid() || part_[mesh_.face(g)] == part) continue;
        if (try_join(part, h, part_[mesh_.face(g)], g)) return;
      }
    }
  }

  bool try_join(int a, HalfedgeId h, int b, HalfedgeId g) {
    if (panels_[a].size() > panels_[b].size()) {
      std::swap(a, b);
      std::swap(h, g);
    }
    const Motion2 motion = carry(at_[h], at_[mesh_.next(h)], at_[mesh_.next(g)], at_[g]);
    if (!fits(a, motion, b)) return false;
    for (int f : panels_[a]) {
      for (int i = 0; i < faces_.degree(f); ++i) corners(f)[i] = motion(corners(f)[i]);
      grids_[b].insert(f, box_of(corners(f), faces_.degree(f)));
      part_[f] = b;
    }
    panels_[b].insert(panels_[b].end(), panels_[a].begin(), panels_[a].end());
    panels_[a].clear();
    forest_.is_fold[mesh_.edge(h)] = 1;
    return true;
  }

  bool fits(int part, const Motion2& motion, int into) {
    std::vector<Vec2> moved;
    for (int f : panels_[part]) {
      moved.resize(faces_.degree(f));
      for (int i = 0; i < faces_.degree(f); ++i) moved[i] = motion(corners(f)[i]);
      bool free = true;
      grids_[into].visit_meeting(box_of(moved.data(), faces_.degree(f)), [&](int other) {
        free = !faces_.overlap(f, moved.data(), other, corners(other));
        return free;
      });
      if (!free) return false;
    }
    return true;
  }

  Vec2* corners(int face) { return &at_[mesh_.soup().offsets[face]]; }

  const FlatFaces& faces_;
  const Mesh& mesh_;
  FoldForest forest_;
  std::vector<Vec2> at_;
  std::vector<int> part_;
  std::vector<std::vector<int>> panels_;
  std::vector<PanelGrid> grids_;
};

// The trees of a forest from their lowest faces down, and which of their folds are cut.
class Branches {
 public:
  Branches(const Mesh& mesh, FoldForest& forest)
      : mesh_(mesh), forest_(forest), above_(mesh.num_faces()), size_(mesh.num_faces(), 1) {
    std::vector<char> seen(mesh.num_faces(), 0);
    for (FaceId f : mesh.faces())
      if (!seen[f]) walk(f, seen);
  }

  bool together(int a, int b) const { return root(a) == root(b); }
  void cut_smaller(int a, int b) {
    const int panel = size_[a] <= size_[b] ? a : b;  // never the one the other hangs from
    forest_.is_fold[mesh_.edge(above_[panel])] = 0;
    above_[panel] = HalfedgeId();
  }

 private:
  void walk(FaceId first, std::vector<char>& seen) {
    std::vector<FaceId> order{first};
    seen[first] = 1;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (HalfedgeId h : mesh_.halfedges(order[i])) {
        if (!forest_.is_fold[mesh_.edge(h)] || seen[mesh_.face(mesh_.twin(h))]) continue;
        const FaceId below = mesh_.face(mesh_.twin(h));
        seen[below] = 1;
        above_[below] = h;
        order.push_back(below);
      }
    }
    for (std::size_t i = order.size(); i-- > 1;) size_[mesh_.face(above_[order[i]])] += size_[order[i]];
  }
  int root(int panel) const {
    while (above_[panel].valid()) panel = mesh_.face(above_[panel]);
    return panel;
  }

  const Mesh& mesh_;
  FoldForest& forest_;
  std::vector<HalfedgeId> above_;  // the side of the panel above
  std::vector<int> size_;          // panels of the branch, as they were at first
};

}  // namespace

void part_pairs(const Mesh& mesh, FoldForest& forest, const std::vector<std::pair<int, int>>& pairs) {
  Branches branches(mesh, forest);
  for (const auto& [a, b] : pairs)
    if (branches.together(a, b)) branches.cut_smaller(a, b);
}

FoldForest part_overlaps(const FlatFaces& faces, const FoldForest& tree) {
  const DualTree laid(faces, tree);
  if (laid.num_overlaps() == 0) return tree;
  Cutting cutting(laid);
  cutting.part_all();
  FoldForest forest = tree;
  for (FaceId f : faces.mesh().faces())
    if (cutting.cut(f)) forest.is_fold[faces.mesh().edge(HalfedgeId(laid.parent_side(f)))] = 0;
  return Joining(faces, std::move(forest), lay_panels(faces, tree)).run();
}

}  // namespace plico
