// Exact decisions about points: which side, inside or not. Filtered: doubles when they are certain, exact arithmetic
// otherwise (CGAL's kernel, hidden in the source). Constructions are in other headers and are rounded.
#pragma once
#include <cmath>

#include "plico/base/vec.h"

namespace plico {

int orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c);
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// +1 when a, b, c turn left (counter-clockwise), -1 when they turn right, 0 when exactly collinear.
// The filter is Shewchuk's first stage (Adaptive precision floating-point arithmetic, 1997).
inline int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right, bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return orient2d_exact(a, b, c);
}

// +1 when d lies below the plane a, b, c, that is when a, b, c look clockwise seen from d; the sign of
// det(a - d, b - d, c - d); 0 when exactly coplanar.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace plico
