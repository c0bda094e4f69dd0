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

HullTracker::HullTracker(const DualTree& tree) : tree_(tree), on_hull_(tree.mesh().num_faces(), 0) {
  const Vec2* all = tree_.corners(0);
  hull_ = convex_hull(outer_points({all, all + tree_.mesh().num_halfedges()}));
  find_panels();
}

const std::vector<Vec2>& HullTracker::least_hull_if_hung(int side) {
  const Motion2 motion = tree_.motion_for(side);
  std::vector<Vec2> points = hull_without_branch();
  for (int panel : tree_.branch()) {
    const Vec2* at = tree_.corners(panel);
    for (int i = 0; i < tree_.mesh().degree(FaceId(panel)); ++i) points.push_back(motion(at[i]));
  }
  proposed_ = convex_hull(outer_points(points));
  return proposed_;
}

std::vector<Vec2> HullTracker::hull_without_branch() {
  std::vector<Vec2> leaving;
  for (int panel : tree_.branch()) {
    const Vec2* at = tree_.corners(panel);
    if (on_hull_[panel]) leaving.insert(leaving.end(), at, at + tree_.mesh().degree(FaceId(panel)));
  }
  touches_ = !leaving.empty();
  std::vector<Vec2> kept;
  for (const Vec2& p : hull_)
    if (std::find(leaving.begin(), leaving.end(), p) == leaving.end()) kept.push_back(p);
  return kept;
}

const std::vector<Vec2>& HullTracker::hull_if_hung(int side) {
  if (!touches_) return proposed_;
  const Motion2 motion = tree_.motion_for(side);
  const Vec2* all = tree_.corners(0);
  std::vector<Vec2> points(all, all + tree_.mesh().num_halfedges());
  for (int panel : tree_.branch()) {
    const int first = tree_.mesh().soup().offsets[panel], end = tree_.mesh().soup().offsets[panel + 1];
    for (int i = first; i < end; ++i) points[i] = motion(all[i]);
  }
  proposed_ = convex_hull(outer_points(points));
  return proposed_;
}

void HullTracker::accept() {
  const bool same = proposed_ == hull_;
  std::swap(hull_, proposed_);
  if (!same || touches_) find_panels();
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

void HullTracker::find_panels() {
  for (int panel : panels_) on_hull_[panel] = 0;
  panels_.clear();
  std::vector<Vec2> sorted = hull_;
  std::sort(sorted.begin(), sorted.end(), before);
  const Vec2* all = tree_.corners(0);
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
