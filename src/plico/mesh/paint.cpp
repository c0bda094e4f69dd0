#include "plico/mesh/paint.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

constexpr double kSameColor = 1.0 / 255;  // nobody sees less

bool look_same(const Color& a, const Color& b) {
  return std::ranges::all_of(std::array{0, 1, 2}, [&](std::size_t k) { return std::abs(a[k] - b[k]) <= kSameColor; });
}

// Where p lies along the side from `a`, in [0, 1]; 0 on a side without length.
double along(const Vec3& a, const Vec3& side, const Vec3& p) {
  const double length = side.squaredNorm();
  return length > 0 ? std::clamp((p - a).dot(side) / length, 0.0, 1.0) : 0;
}

// On the nearest of the three sides.
Vec3 weights_on_rim(const std::array<Vec3, 3>& corners, const Vec3& p) {
  Vec3 best(1, 0, 0);
  double least = (p - corners[0]).squaredNorm();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3 side = corners[j] - corners[i];
    const double t = along(corners[i], side, p), distance = (p - corners[i] - t * side).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    best = Vec3::Zero();
    best[i] = 1 - t, best[j] = t;
  }
  return best;
}

}  // namespace

bool PaintedTriangle::is_plain() const {
  return picture < 0 && look_same(colors[0], colors[1]) && look_same(colors[0], colors[2]);
}

Vec2 PaintedTriangle::uv_at(const Vec3& weights) const {
  return weights[0] * uv[0] + weights[1] * uv[1] + weights[2] * uv[2];
}

Color PaintedTriangle::color_at(const Vec3& weights) const {
  Color color{};
  for (int i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) color[k] += weights[i] * colors[static_cast<std::size_t>(i)][k];
  return color;
}

Color Paint::color_at(int triangle, const Vec3& weights) const {
  const PaintedTriangle& at = triangles[static_cast<std::size_t>(triangle)];
  const Color tint = at.color_at(weights);
  if (at.picture < 0) return tint;
  return product(tint, plico::color_at(pictures[static_cast<std::size_t>(at.picture)], at.uv_at(weights)));
}

Vec3 nearest_weights(const std::array<Vec3, 3>& corners, const Vec3& p) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0], w = p - corners[0];
  const Vec3 normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return weights_on_rim(corners, p);
  const Vec3 weights(0, w.cross(v).dot(normal) / area, u.cross(w).dot(normal) / area);
  const double first = 1 - weights[1] - weights[2];
  if (first < 0 || weights[1] < 0 || weights[2] < 0) return weights_on_rim(corners, p);
  return {first, weights[1], weights[2]};
}

}  // namespace plico
