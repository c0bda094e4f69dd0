#include "plico/geom/convex2.h"

#include <algorithm>
#include <limits>

#include "plico/base/libm.h"
#include "plico/geom/polygon.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

// The coordinates of the hull along u and perpendicular to it, as a box.
Eigen::AlignedBox2d box_along(std::span<const Vec2> hull, const Vec2& u) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : hull) box.extend(Vec2(p.dot(u), cross(u, p)));
  return box;
}

// Is some edge line of `a` a weak separator: all of `b` on or outside it?
bool edge_of_first_separates(std::span<const Vec2> a, std::span<const Vec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 &p = a[i], &q = a[i + 1 == a.size() ? 0 : i + 1];
    if (std::all_of(b.begin(), b.end(), [&](const Vec2& r) { return orient2d(p, q, r) <= 0; })) return true;
  }
  return false;
}

}  // namespace

bool interiors_overlap_convex(std::span<const Vec2> a, std::span<const Vec2> b) {
  return !edge_of_first_separates(a, b) && !edge_of_first_separates(b, a);
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto less = [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= base + 2 && orient2d(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

TurnedRectangle least_area_rectangle(std::span<const Vec2> hull) {
  TurnedRectangle best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {  // one side of the best rectangle lies along an edge of the hull
    const Vec2 along = hull[(i + 1) % hull.size()] - hull[i];
    if (along.norm() == 0) continue;
    const Vec2 size = box_along(hull, along.normalized()).sizes();
    if (size.prod() >= least) continue;
    least = size.prod();
    best = {plico::atan2(along.y(), along.x()), size};
  }
  return best;
}

std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& polygon) {
  if (is_convex(polygon)) return {polygon};
  std::vector<std::vector<Vec2>> pieces;
  for (const auto& [i, j, k] : triangulate(polygon)) pieces.push_back({polygon[i], polygon[j], polygon[k]});
  return pieces;
}

std::vector<Vec2> clipped(std::vector<Vec2> polygon, std::span<const Vec2> window) {
  for (std::size_t i = 0; i < window.size() && !polygon.empty(); ++i) {
    const Vec2& from = window[i];
    const Vec2 along = window[(i + 1) % window.size()] - from;
    std::vector<Vec2> inside;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double at_p = cross(along, p - from), at_q = cross(along, q - from);
      if (at_p >= 0) inside.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) inside.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = std::move(inside);
  }
  return polygon;
}

}  // namespace plico
