#include "plico/unfold/hull_tracker.h"

#include <algorithm>
#include <array>

#include "plico/geom/polygon.h"

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

HullTracker::HullTracker(const DualTree& tree) : tree_(tree), on_hull_(tree.mesh().num_faces(), 0) {
  const Vec2* all = tree_.corners(0);
  points_.assign(all, all + tree_.mesh().num_halfedges());
  hull_ = convex_hull(outer_points());
  find_panels();
}

const std::vector<Vec2>& HullTracker::hull_if_hung(int side) {
  const Motion2 motion = tree_.motion_for(side);
  changed_ = !keeps_hull(motion);
  if (!changed_) return hull_;
  collect(motion);
  proposed_ = convex_hull(outer_points());
  return proposed_;
}

void HullTracker::accept() {
  if (!changed_) return;
  std::swap(hull_, proposed_);
  find_panels();
}

bool HullTracker::keeps_hull(const Motion2& motion) const {
  Box2 box{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (int panel : tree_.branch()) {
    if (on_hull_[panel]) return false;
    const Vec2* at = tree_.corners(panel);
    for (int i = 0; i < tree_.mesh().degree(FaceId(panel)); ++i) {
      const Vec2 p = motion(at[i]);
      box = {std::min(box.x0, p.x()), std::min(box.y0, p.y()), std::max(box.x1, p.x()), std::max(box.y1, p.y())};
    }
  }
  return contains({box.x0, box.y0}) && contains({box.x1, box.y0}) && contains({box.x1, box.y1}) &&
         contains({box.x0, box.y1});
}

bool HullTracker::contains(const Vec2& p) const { return strictly_inside(p, hull_.data(), hull_.size()); }

void HullTracker::collect(const Motion2& motion) {
  const Vec2* all = tree_.corners(0);
  points_.assign(all, all + tree_.mesh().num_halfedges());
  for (int panel : tree_.branch()) {
    const int first = tree_.mesh().soup().offsets[panel], end = tree_.mesh().soup().offsets[panel + 1];
    for (int i = first; i < end; ++i) points_[i] = motion(all[i]);
  }
}

// Points strictly inside the octagon of extreme points cannot be on the hull (Akl and Toussaint 1978).
std::vector<Vec2> HullTracker::outer_points() const {
  static const std::array<Vec2, 8> kDirections = {Vec2(1, 0),  Vec2(1, 1),   Vec2(0, 1),  Vec2(-1, 1),
                                                  Vec2(-1, 0), Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1)};
  std::array<Vec2, 8> octagon;
  std::array<double, 8> farthest;
  farthest.fill(-INFINITY);
  for (const Vec2& p : points_) {
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
  for (const Vec2& p : points_)
    if (n < 3 || !strictly_inside(p, octagon.data(), n)) outer.push_back(p);
  return outer;
}

void HullTracker::find_panels() {
  for (int panel : panels_) on_hull_[panel] = 0;
  panels_.clear();
  std::vector<Vec2> sorted = hull_;
  std::sort(sorted.begin(), sorted.end(), before);
  const Vec2* all = points_.data();
  for (int panel = 0; panel < tree_.mesh().num_faces(); ++panel) {
    const int first = tree_.mesh().soup().offsets[panel], end = tree_.mesh().soup().offsets[panel + 1];
    if (std::none_of(all + first, all + end,
                     [&](const Vec2& p) { return std::binary_search(sorted.begin(), sorted.end(), p, before); }))
      continue;
    on_hull_[panel] = 1;
    panels_.push_back(panel);
  }
}

}  // namespace plico
