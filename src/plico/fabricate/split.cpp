#include "plico/fabricate/split.h"

#include <algorithm>

#include "plico/base/libm.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

Vec2 extent(std::span<const Vec2> hull, double angle) {
  const Eigen::Matrix2d turn = rotation(angle);
  Eigen::AlignedBox2d box;
  for (const Vec2& p : hull) box.extend(turn * p);
  return box.sizes();
}

// Calls visit(angle) until it says true.
template <class Visit>
void each_angle(std::span<const Vec2> hull, Visit visit) {
  if (visit(0.0)) return;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const double angle = -plico::atan2(side.y(), side.x());
    if (visit(angle) || visit(angle + kPi / 2)) return;
  }
  for (int i = 1; i < 36; ++i)
    if (visit(radians(5.0 * i))) return;
}

// Grows pieces from the leaves of each tree of panels.
class Splitter {
 public:
  Splitter(const NetSides& sides, const Vec2& room) : sides_(sides), net_(sides.net()), room_(room) {}

  std::vector<char> run() {
    walk_trees();
    std::vector<char> is_cut(net_.sheet.num_edges(), 0);
    std::vector<std::vector<Vec2>> hull(net_.sheet.num_faces());
    std::vector<std::vector<int>> children(net_.sheet.num_faces());
    for (auto at = order_.rbegin(); at != order_.rend(); ++at) {
      const int f = *at;
      hull[f] = convex_hull(polygon(net_.sheet, f));
      auto& kids = children[f];
      std::ranges::stable_sort(kids, {}, [&](int k) { return signed_area(hull[k]); });
      for (int k : kids) {
        std::vector<Vec2> both = hull[f];
        both.insert(both.end(), hull[k].begin(), hull[k].end());
        both = convex_hull(std::move(both));
        if (angle_that_fits(both, room_))
          hull[f] = std::move(both);
        else
          is_cut[parent_edge_[k]] = 1;
        hull[k] = {};
      }
      if (parent_[f] >= 0) children[parent_[f]].push_back(f);
    }
    return is_cut;
  }

 private:
  void walk_trees() {
    parent_.assign(net_.sheet.num_faces(), -1);
    parent_edge_.assign(net_.sheet.num_faces(), -1);
    std::vector<char> seen(net_.sheet.num_faces(), 0);
    for (int root = 0; root < net_.sheet.num_faces(); ++root) {
      if (seen[root]) continue;
      seen[root] = 1;
      order_.push_back(root);
      for (std::size_t at = order_.size() - 1; at < order_.size(); ++at) {
        for (int e : sides_.edges(order_[at])) {
          if (!sides_.is_fold(e)) continue;
          const int a = sides_.side(e).panel, b = sides_.second_side(e).panel, other = a == order_[at] ? b : a;
          if (seen[other]) continue;
          seen[other] = 1;
          parent_[other] = order_[at];
          parent_edge_[other] = e;
          order_.push_back(other);
        }
      }
    }
  }

  const NetSides& sides_;
  const Unfolding& net_;
  const Vec2 room_;
  std::vector<int> order_, parent_, parent_edge_;
};

}  // namespace

std::optional<double> angle_that_fits(std::span<const Vec2> hull, const Vec2& room) {
  std::optional<double> found;
  each_angle(hull, [&](double angle) {
    const Vec2 size = extent(hull, angle);
    if (size.x() > room.x() || size.y() > room.y()) return false;
    found = angle;
    return true;
  });
  return found;
}

double largest_scale(std::span<const Vec2> hull, const Vec2& room) {
  double best = 0;
  each_angle(hull, [&](double angle) {
    best = std::max(best, (room.array() / extent(hull, angle).array()).minCoeff());
    return false;
  });
  return best;
}

std::vector<char> cuts_to_fit(const NetSides& sides, const Vec2& room) { return Splitter(sides, room).run(); }

}  // namespace plico
