#include "plico/mesh/paint.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

constexpr double kSameColor = 1.0 / 255;  // nobody sees less

bool look_same(const Color& a, const Color& b) {
  return std::ranges::all_of(std::array{0, 1, 2}, [&](std::size_t k) { return std::abs(a[k] - b[k]) <= kSameColor; });
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

}  // namespace plico
