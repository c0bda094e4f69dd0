#include "plico/geom/polygon.h"

#include <algorithm>
#include <numeric>

#include "plico/base/libm.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

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

}  // namespace plico
