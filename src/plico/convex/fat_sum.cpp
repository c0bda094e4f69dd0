#include "plico/convex/remesh_steps.h"

namespace plico {

void FatSum::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double x = (b - c).norm(), y = (c - a).norm(), z = (a - b).norm();
  const double twice = (b - a).cross(c - a).norm();
  if (!(x * y * z > 0)) return;
  // cos a + cos b + cos c - 1 = r / R = 2 (2 area)^2 / ((x + y + z) x y z).
  fat += twice * 2 * twice * twice / ((x + y + z) * x * y * z);
  area += twice;
}

FatSum fat_sum(const ShellSurface& surface, const std::vector<int>& triangles) {
  FatSum sum;
  for (int t : triangles) {
    const auto& c = surface.triangle(t);
    sum.add(surface.point(c[0]), surface.point(c[1]), surface.point(c[2]));
  }
  return sum;
}

FatSum fat_sum(const ShellSurface& surface) { return fat_sum(surface, surface.triangles()); }

FatSum fan_sum(const ShellSurface& surface, const ShellSurface::Patch& patch, const Vec3& tip) {
  FatSum sum;
  for (std::size_t i = 0; i < patch.loop.size(); ++i)
    sum.add(surface.point(patch.loop[i]), surface.point(patch.loop[(i + 1) % patch.loop.size()]), tip);
  return sum;
}

}  // namespace plico
