#include "plico/geom/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "plico/geom/convex3.h"

namespace plico {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_2 to_cgal(const Vec2& p) { return {p.x(), p.y()}; }
Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
}  // namespace

int orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c)));
}

// CGAL's orientation is the sign of det(b - a, c - a, d - a), which is minus that of det(a - d, b - d, c - d).
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return -static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ad = a - d, bd = b - d, cd = c - d;
  const double bc1 = bd.x() * cd.y(), bc2 = cd.x() * bd.y();
  const double ca1 = cd.x() * ad.y(), ca2 = ad.x() * cd.y();
  const double ab1 = ad.x() * bd.y(), ab2 = bd.x() * ad.y();
  const double det = ad.z() * (bc1 - bc2) + bd.z() * (ca1 - ca2) + cd.z() * (ab1 - ab2);
  const double permanent = (std::abs(bc1) + std::abs(bc2)) * std::abs(ad.z()) +
                           (std::abs(ca1) + std::abs(ca2)) * std::abs(bd.z()) +
                           (std::abs(ab1) + std::abs(ab2)) * std::abs(cd.z());
  const double bound = 7.771561172376103e-16 * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return orient3d_exact(a, b, c, d);
}

int side_of_plane(const Plane& plane, const Vec3& point) {
  const Vec3& n = plane.normal;
  return static_cast<int>(Kernel::Plane_3(n.x(), n.y(), n.z(), -plane.offset).oriented_side(to_cgal(point)));
}

}  // namespace plico
