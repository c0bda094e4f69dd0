#include "plico/verify/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace plico {
namespace {

using Plate = std::span<const Vec3>;

Vec3 corner_after(Plate plate, std::size_t i) { return plate[i + 1 == plate.size() ? 0 : i + 1]; }

// Newell's: right for every planar polygon, however its first corners lie.
Vec3 plane_normal(Plate plate) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < plate.size(); ++i)
    normal += (plate[i] - plate[0]).cross(corner_after(plate, i) - plate[0]);
  return normal;
}

// The shortest vector from segment q to segment p (Ericson, Real-Time Collision Detection, 5.1.9).
Vec3 between_segments(const Vec3& p, const Vec3& along_p, const Vec3& q, const Vec3& along_q) {
  const Vec3 r = p - q;
  const double a = along_p.squaredNorm(), e = along_q.squaredNorm(), f = along_q.dot(r), c = along_p.dot(r);
  const double b = along_p.dot(along_q), det = a * e - b * b;
  double s = det > 1e-14 * a * e ? std::clamp((b * f - c * e) / det, 0.0, 1.0) : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
  }
  return (p + s * along_p) - (q + t * along_q);
}

// Is the point, dropped on the plate's plane, inside the plate?
bool above(Plate plate, const Vec3& normal, const Vec3& point) {
  for (std::size_t i = 0; i < plate.size(); ++i)
    if (normal.dot((corner_after(plate, i) - plate[i]).cross(point - plate[i])) < 0) return false;
  return true;
}

// Keeps the shortest of the vectors it is shown.
struct Shortest {
  Vec3 vector = Vec3::Zero();
  double squared = std::numeric_limits<double>::infinity();
  void see(const Vec3& v) {
    const double d = v.squaredNorm();
    if (d < squared) squared = d, vector = v;
  }
};

// Corners of `points` against the inside of `plate`; `sign` turns the vector to point from b to a. Also sees sides of
// `points` that pierce the plate, as the zero vector.
void see_corners(Plate points, Plate plate, const Vec3& normal, double sign, Shortest& shortest) {
  const double squared = normal.squaredNorm();
  const auto height = [&](const Vec3& p) { return normal.dot(p - plate[0]); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double h = height(points[i]), next = height(corner_after(points, i));
    if (h * h < shortest.squared * squared && above(plate, normal, points[i]))
      shortest.see(normal * (sign * h / squared));
    if ((h < 0) != (next < 0) &&
        above(plate, normal, points[i] + (h / (h - next)) * (corner_after(points, i) - points[i])))
      shortest.see(Vec3::Zero());
  }
}

std::vector<Vec3> sides(Plate plate) {
  std::vector<Vec3> along;
  for (std::size_t i = 0; i < plate.size(); ++i) along.emplace_back(corner_after(plate, i) - plate[i]);
  return along;
}

// The axis along which two bodies come apart soonest: of the normals of their faces and all products of their edges.
Separation soonest(Plate a, Plate b, std::span<const Vec3> normals, std::span<const Vec3> edges_a,
                   std::span<const Vec3> edges_b) {
  Separation best{-std::numeric_limits<double>::infinity(), Vec3::UnitX()};
  const auto see = [&](const Vec3& axis) {
    const Vec3 unit = axis.normalized();
    for (const Vec3& direction : {unit, Vec3(-unit)})
      if (const double ahead = lead(a, b, direction); ahead > best.value) best = {ahead, direction};
  };
  for (const Vec3& normal : normals) see(normal);
  for (const Vec3& u : edges_a) {
    for (const Vec3& v : edges_b) {
      const Vec3 axis = u.cross(v);
      if (axis.squaredNorm() > 1e-16 * u.squaredNorm() * v.squaredNorm()) see(axis);
    }
  }
  return best;
}

// One end of a prism, and what leads from it to the other.
Plate end_of(Plate prism) { return prism.first(prism.size() / 2); }
Vec3 way_through(Plate prism) { return prism[prism.size() / 2] - prism[0]; }

void add_faces(Plate prism, std::vector<Vec3>& normals) {
  normals.push_back(plane_normal(end_of(prism)));
  for (const Vec3& side : sides(end_of(prism))) normals.emplace_back(side.cross(way_through(prism)));
}

std::vector<Vec3> edges_of_prism(Plate prism) {
  std::vector<Vec3> edges = sides(end_of(prism));
  edges.push_back(way_through(prism));
  return edges;
}

}  // namespace

double lead(Plate a, Plate b, const Vec3& direction) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& p : a) low = std::min(low, direction.dot(p));
  for (const Vec3& p : b) high = std::max(high, direction.dot(p));
  return low - high;
}

Separation separation(Plate a, Plate b) {
  const Vec3 normal_a = plane_normal(a), normal_b = plane_normal(b);
  Shortest shortest;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 along = corner_after(a, i) - a[i];
    for (std::size_t j = 0; j < b.size(); ++j)
      shortest.see(between_segments(a[i], along, b[j], corner_after(b, j) - b[j]));
  }
  see_corners(a, b, normal_b, 1, shortest);
  see_corners(b, a, normal_a, -1, shortest);
  if (shortest.squared > 0) {
    const double distance = std::sqrt(shortest.squared);
    const Vec3 direction = shortest.vector / distance;
    // Rounding may miss a side that just pierces; then the direction does not separate and the depth decides.
    const double ahead = lead(a, b, direction);
    if (ahead > 0.5 * distance) return {ahead, direction};
  }
  return soonest(a, b, std::array{normal_a, normal_b}, sides(a), sides(b));
}

Separation separation_of_prisms(std::span<const Vec3> a, std::span<const Vec3> b) {
  std::vector<Vec3> normals;
  add_faces(a, normals);
  add_faces(b, normals);
  return soonest(a, b, normals, edges_of_prism(a), edges_of_prism(b));
}

}  // namespace plico
