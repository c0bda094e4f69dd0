#include "plico/geom/polygon.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "plico/base/libm.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

// The coordinates of the hull along u and perpendicular to it, as a box.
Eigen::AlignedBox2d box_along(std::span<const Vec2> hull, const Vec2& u) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : hull) box.extend(Vec2(p.dot(u), cross(u, p)));
  return box;
}

// No corner of the polygon inside or on the ear (a, b, c).
bool is_ear(std::span<const Vec2> polygon, const std::vector<int>& left, int i, int j, int k) {
  const Vec2 &a = polygon[i], &b = polygon[j], &c = polygon[k];
  if (orient2d(a, b, c) <= 0) return false;
  return std::none_of(left.begin(), left.end(), [&](int m) {
    if (m == i || m == j || m == k) return false;
    const Vec2& p = polygon[m];
    return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
  });
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

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += cross(Vec2(polygon[i - 1] - polygon[0]), Vec2(polygon[i] - polygon[0]));
  return twice / 2;
}

double perimeter(std::span<const Vec2> polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += (polygon[i] - polygon[(i + 1) % polygon.size()]).norm();
  return sum;
}

Vec2 centroid(std::span<const Vec2> polygon) {
  Vec2 sum = Vec2::Zero(), mean = Vec2::Zero();
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const double w = cross(a, b);
    twice += w;
    sum += w * (a + b);
    mean += a;
  }
  if (twice == 0) return polygon[0] + mean / static_cast<double>(polygon.size());
  return polygon[0] + sum / (3 * twice);
}

bool is_convex(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  double turned = 0;  // a star polygon turns left everywhere too, but more than once around
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    if (orient2d(a, b, c) < 0) return false;
    turned += plico::atan2(cross(Vec2(b - a), Vec2(c - b)), (b - a).dot(c - b));
  }
  return turned < 3 * kPi;
}

std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon) {
  std::vector<int> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t ear = 0;
    while (ear < n && !is_ear(polygon, left, left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n])) ++ear;
    if (ear == n) ear = 0;  // not simple: go on with any corner
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (left.size() == 3) triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

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

}  // namespace plico
