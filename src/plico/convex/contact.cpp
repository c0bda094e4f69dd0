#include "plico/convex/contact.h"

#include <algorithm>
#include <cmath>

#include "plico/convex/cut_loss.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

std::vector<Vec2> footprint(const ConvexPolyhedron& body, const PlaneFrame& frame, double tolerance) {
  std::vector<Vec2> points;
  for (const Vec3& p : body.points) {
    const Vec3 local = frame.axes.transpose() * (p - frame.origin);
    if (std::abs(local.z()) <= tolerance) points.push_back(local.head<2>());
  }
  return convex_hull(std::move(points));
}

// The part of a polygon to the left of the line a b.
std::vector<Vec2> left_part(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double hp = cross(b - a, p - a), hq = cross(b - a, q - a);
    if (hp >= 0) kept.push_back(p);
    if ((hp >= 0) != (hq >= 0)) kept.push_back(p + hp / (hp - hq) * (q - p));
  }
  return kept;
}

// Distance to a segment.
double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

// Without corners that are none: next to the one before, or on the side between their neighbours.
std::vector<Vec2> without_flat_corners(std::vector<Vec2> polygon, double tolerance) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
    const std::size_t n = polygon.size();
    if (distance(polygon[i], polygon[(i + n - 1) % n], polygon[(i + 1) % n]) <= tolerance) {
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    } else {
      ++i;
    }
  }
  return polygon;
}

}  // namespace

std::vector<Vec3> contact_polygon(const ConvexPolyhedron& below, const ConvexPolyhedron& above, const Plane& plane,
                                  double tolerance) {
  const PlaneFrame frame = frame_of(plane, below.points.front());
  std::vector<Vec2> shared = footprint(below, frame, tolerance);
  const std::vector<Vec2> other = footprint(above, frame, tolerance);
  if (shared.size() < 3 || other.size() < 3) return {};
  for (std::size_t i = 0; i < other.size() && !shared.empty(); ++i)
    shared = left_part(shared, other[i], other[(i + 1) % other.size()]);
  shared = without_flat_corners(convex_hull(std::move(shared)), 4 * tolerance);
  if (shared.size() < 3 || signed_area(shared) <= tolerance * perimeter(shared)) return {};
  std::vector<Vec3> polygon;
  for (const Vec2& p : shared) polygon.push_back(frame.origin + frame.axes * Vec3(p.x(), p.y(), 0));
  return polygon;
}

}  // namespace plico
