#include "plico/fabricate/split.h"

#include <algorithm>

#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/rectangle_fit.h"

namespace plico {
namespace {

// Grows pieces from the leaves of each tree of panels, towards several roots.
class Splitter {
 public:
  Splitter(const NetSides& sides, const Vec2& room)
      : sides_(sides),
        net_(sides.net()),
        room_(room),
        parent_(net_.sheet.num_faces(), -1),
        parent_edge_(net_.sheet.num_faces(), -1),
        seen_(net_.sheet.num_faces(), -1),
        hull_(net_.sheet.num_faces()),
        children_(net_.sheet.num_faces()) {}

  std::vector<char> run() {
    std::vector<char> is_cut(net_.sheet.num_edges(), 0);
    for (int first = 0; first < net_.sheet.num_faces(); ++first) {
      if (seen_[first] >= 0) continue;
      for (int e : best_split(first).cuts) is_cut[e] = 1;
    }
    return is_cut;
  }

 private:
  static constexpr int kMostRoots = 32;
  static constexpr int kMostVisits = 10'000;  // of panels of a tree, for all its roots

  struct Split {
    std::vector<int> cuts;  // edges
    double hulls = 0;       // area of the hulls of all pieces
    auto key() const { return std::pair(cuts.size(), hulls); }
  };

  // The fewest pieces, and of those the most compact.
  Split best_split(int first) {
    Split best = split_towards(first);
    const std::vector<int> tree = order_;
    const int size = static_cast<int>(tree.size()), roots = std::min({size, kMostRoots, kMostVisits / size});
    for (int i = 1; i < roots && !best.cuts.empty(); ++i) {
      Split other = split_towards(tree[i * static_cast<long>(size) / roots]);
      if (other.key() < best.key()) best = std::move(other);
    }
    return best;
  }

  Split split_towards(int root) {
    walk_tree(root);
    Split split;
    const auto finish = [&](int f) {
      split.hulls += signed_area(hull_[f]);
      hull_[f] = {};
    };
    for (auto at = order_.rbegin(); at != order_.rend(); ++at) {
      const int f = *at;
      hull_[f] = convex_hull(polygon(net_.sheet, f));
      auto& kids = children_[f];
      std::ranges::stable_sort(kids, {}, [&](int k) { return signed_area(hull_[k]); });
      for (int k : kids) {
        std::vector<Vec2> both = hull_[f];
        both.insert(both.end(), hull_[k].begin(), hull_[k].end());
        both = convex_hull(std::move(both));
        if (angle_that_fits(both, room_)) {
          hull_[f] = std::move(both);
          hull_[k] = {};
        } else {
          split.cuts.push_back(parent_edge_[k]);
          finish(k);
        }
      }
      kids.clear();
      if (f != root) children_[parent_[f]].push_back(f);
    }
    finish(root);
    return split;
  }

  // From the root to the leaves.
  void walk_tree(int root) {
    ++walk_;
    seen_[root] = walk_;
    order_.assign(1, root);
    for (std::size_t at = 0; at < order_.size(); ++at) {
      for (int e : sides_.edges(order_[at])) {
        if (!sides_.is_fold(e)) continue;
        const int a = sides_.side(e).panel, b = sides_.second_side(e).panel, other = a == order_[at] ? b : a;
        if (seen_[other] == walk_) continue;
        seen_[other] = walk_;
        parent_[other] = order_[at];
        parent_edge_[other] = e;
        order_.push_back(other);
      }
    }
  }

  const NetSides& sides_;
  const Unfolding& net_;
  const Vec2 room_;
  int walk_ = 0;
  std::vector<int> order_, parent_, parent_edge_;
  std::vector<int> seen_;  // by which walk
  std::vector<std::vector<Vec2>> hull_;
  std::vector<std::vector<int>> children_;
};

}  // namespace

std::vector<char> cuts_to_fit(const NetSides& sides, const Vec2& room) { return Splitter(sides, room).run(); }

}  // namespace plico
