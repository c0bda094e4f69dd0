#include "plico/unfold/hull_tracker.h"

#include <algorithm>
#include <array>

#include "plico/geom/convex2.h"

namespace plico {
namespace {

bool before(const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

// Strictly inside a counter-clockwise convex polygon. Rounded: who is taken for outside is only looked at longer.
bool strictly_inside(const Vec2& p, const Vec2* polygon, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1 == n ? 0 : i + 1];
    if (cross(Vec2(b - a), Vec2(p - a)) <= 0) return false;
  }
  return true;
}

}  // namespace

HullTracker::HullTracker(const DualTree& tree, const std::vector<char>& is_cut)
    : tree_(tree), piece_(tree.mesh().num_faces(), -1), on_hull_(tree.mesh().num_faces(), 0) {
  find_pieces(is_cut);
  hulls_.resize(members_.size());
  for (std::size_t p = 0; p < members_.size(); ++p) {
    std::vector<Vec2> points;
    for (int panel : members_[p]) {
      const Vec2* at = tree_.corners(panel);
      points.insert(points.end(), at, at + tree_.mesh().degree(FaceId(panel)));
    }
    hulls_[p] = convex_hull(outer_points(points));
    find_panels(static_cast<int>(p));
  }
}

void HullTracker::find_pieces(const std::vector<char>& is_cut) {
  const Mesh& mesh = tree_.mesh();
  const auto folds = [&](HalfedgeId h) {
    const HalfedgeId g = mesh.twin(h);
    if (!g.valid() || (!is_cut.empty() && is_cut[mesh.edge(h)])) return false;
    return tree_.parent_side(mesh.face(h)) == h || tree_.parent_side(mesh.face(g)) == g;
  };
  for (int first = 0; first < mesh.num_faces(); ++first) {
    if (piece_[first] >= 0) continue;
    const int piece = static_cast<int>(members_.size());
    std::vector<int> found{first};
    piece_[first] = piece;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (HalfedgeId h : mesh.halfedges(FaceId(found[i]))) {
        if (!folds(h) || piece_[mesh.face(mesh.twin(h))] >= 0) continue;
        piece_[mesh.face(mesh.twin(h))] = piece;
        found.push_back(mesh.face(mesh.twin(h)));
      }
    }
    members_.push_back(std::move(found));
  }
}

const HullTracker::Change& HullTracker::least_if_hung(int side) {
  const Mesh& mesh = tree_.mesh();
  proposed_.from = piece_[tree_.branch().front()];
  proposed_.to = piece_[mesh.face(mesh.twin(HalfedgeId(side)))];
  std::vector<Vec2> points = hull_without_branch();
  if (proposed_.from != proposed_.to) {
    proposed_.left = touches_ ? convex_hull(points) : hulls_[proposed_.from];
    points = hulls_[proposed_.to];
  }
  add_moved(side, points);
  proposed_.gained = convex_hull(outer_points(points));
  return proposed_;
}

void HullTracker::add_moved(int side, std::vector<Vec2>& points) const {
  const Motion2 motion = tree_.motion_for(side);
  for (int panel : tree_.branch()) {
    if (piece_[panel] != proposed_.from) continue;
    const Vec2* at = tree_.corners(panel);
    for (int i = 0; i < tree_.mesh().degree(FaceId(panel)); ++i) points.push_back(motion(at[i]));
  }
}

Hull2 HullTracker::hull_without_branch() {
  std::vector<Vec2> leaving;
  for (int panel : tree_.branch()) {
    const Vec2* at = tree_.corners(panel);
    if (on_hull_[panel] && piece_[panel] == proposed_.from)
      leaving.insert(leaving.end(), at, at + tree_.mesh().degree(FaceId(panel)));
  }
  touches_ = !leaving.empty();
  Hull2 kept;
  for (const Vec2& p : hulls_[proposed_.from])
    if (std::find(leaving.begin(), leaving.end(), p) == leaving.end()) kept.push_back(p);
  return kept;
}

const HullTracker::Change& HullTracker::all_if_hung(int side) {
  if (!touches_) return proposed_;
  std::vector<Vec2> points;
  for (int panel : members_[proposed_.from]) {
    if (moves(panel)) continue;
    const Vec2* at = tree_.corners(panel);
    points.insert(points.end(), at, at + tree_.mesh().degree(FaceId(panel)));
  }
  if (proposed_.from == proposed_.to) {
    add_moved(side, points);
    proposed_.gained = convex_hull(outer_points(points));
  } else {
    proposed_.left = convex_hull(outer_points(points));
  }
  return proposed_;
}

void HullTracker::accept() {
  const auto [from, to] = std::pair(proposed_.from, proposed_.to);
  const bool same = from == to && proposed_.gained == hulls_[to];
  if (from != to) {
    std::vector<int>& source = members_[from];
    const auto stay = std::stable_partition(source.begin(), source.end(), [&](int panel) { return !moves(panel); });
    for (auto panel = stay; panel != source.end(); ++panel) piece_[*panel] = to;
    members_[to].insert(members_[to].end(), stay, source.end());
    source.erase(stay, source.end());
    std::swap(hulls_[from], proposed_.left);
  }
  std::swap(hulls_[to], proposed_.gained);
  if (same && !touches_) return;
  if (from != to) find_panels(from);
  find_panels(to);
}

// Points strictly inside the octagon of extreme points cannot be on the hull (Akl and Toussaint 1978).
std::vector<Vec2> HullTracker::outer_points(const std::vector<Vec2>& points) {
  static const std::array<Vec2, 8> kDirections = {Vec2(1, 0),  Vec2(1, 1),   Vec2(0, 1),  Vec2(-1, 1),
                                                  Vec2(-1, 0), Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1)};
  std::array<Vec2, 8> octagon;
  std::array<double, 8> farthest;
  farthest.fill(-INFINITY);
  for (const Vec2& p : points) {
    for (std::size_t k = 0; k < 8; ++k) {
      const double reach = p.dot(kDirections[k]);
      if (reach <= farthest[k]) continue;
      farthest[k] = reach;
      octagon[k] = p;
    }
  }
  // One point may be extreme in several directions; they follow each other.
  const auto end = std::unique(octagon.begin(), octagon.end());
  std::size_t n = end - octagon.begin();
  if (n > 1 && octagon[n - 1] == octagon[0]) --n;
  std::vector<Vec2> outer;
  for (const Vec2& p : points)
    if (n < 3 || !strictly_inside(p, octagon.data(), n)) outer.push_back(p);
  return outer;
}

void HullTracker::find_panels(int piece) {
  std::erase_if(panels_, [&](int panel) { return piece_[panel] == piece; });
  std::vector<Vec2> sorted = hulls_[piece];
  std::sort(sorted.begin(), sorted.end(), before);
  for (int panel : members_[piece]) {
    const Vec2* at = tree_.corners(panel);
    on_hull_[panel] = std::any_of(at, at + tree_.mesh().degree(FaceId(panel)), [&](const Vec2& p) {
      return std::binary_search(sorted.begin(), sorted.end(), p, before);
    });
    if (on_hull_[panel]) panels_.push_back(panel);
  }
}

}  // namespace plico
