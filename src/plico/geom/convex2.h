// Convex polygons in the plane: decisions (exact unless said) and constructions (rounded). Vertices are
// counter-clockwise.
#pragma once
#include <span>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// Do two convex counter-clockwise polygons share an interior point? Touching is not sharing. Exact. O(n m).
bool interiors_overlap_convex(std::span<const Vec2> a, std::span<const Vec2> b);

// Counter-clockwise hull without collinear points (Andrew's monotone chain, exact turns). O(n log n).
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

// The rectangle of least area around a convex counter-clockwise polygon: turned by `angle` radians. O(n^2).
struct TurnedRectangle {
  double angle = 0;  // rotate the polygon by -angle to make the rectangle upright
  Vec2 size = Vec2::Zero();
};
TurnedRectangle least_area_rectangle(std::span<const Vec2> hull);

// The polygon itself when it is convex, its triangles otherwise.
std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& polygon);

// What lies in both: any simple polygon cut by the sides of a convex one (Sutherland and Hodgman 1974). Empty when
// nothing does. Rounded. O(n m).
std::vector<Vec2> clipped(std::vector<Vec2> polygon, std::span<const Vec2> window);

// Does the line of some side of convex `a` separate: all of `b` outside it, or inside by less than `touch`? That is
// asked as twice an area: `touch(side)` is a depth times a length of the side's vector. `a` and `b` have size() and
// [i].
template <class A, class B, class Touch>
bool side_separates(const A& a, const B& b, Touch touch) {
  const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
  for (int i = 0, j = n - 1; i < n; j = i++) {
    const auto& from = a[j];
    const Vec2 side = a[i] - from;
    const double limit = touch(side);
    bool outside = true;
    for (int k = 0; k < m && outside; ++k) outside = cross(side, Vec2(b[k] - from)) <= limit;
    if (outside) return true;
  }
  return false;
}

}  // namespace plico
