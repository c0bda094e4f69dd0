#include "plico/motion/penetration.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plico {
namespace {

// Edges more parallel than this (squared sine) give an axis made of rounding errors; the other axes decide.
constexpr double kParallel = 1e-16;

struct Span {
  double low, high;
};

inline Span project(const Vec3* corners, int count, const Vec3& axis) {
  Span span{axis.dot(corners[0]), 0};
  span.high = span.low;
  for (int i = 1; i < count; ++i) {
    const double d = axis.dot(corners[i]);
    span.low = std::min(span.low, d);
    span.high = std::max(span.high, d);
  }
  return span;
}

inline Span project(const PlacedPlate& plate, const Vec3& axis) { return project(plate.corners, plate.count, axis); }

// A prism's corners are those of both its ends.
Span project_solid(const PlacedPlate& plate, const Vec3& axis) {
  return project(plate.corners, plate.is_thick ? 2 * plate.count : plate.count, axis);
}

inline bool apart(const Span& a, const Span& b, double touch) {
  return b.low - a.high >= -touch || a.low - b.high >= -touch;
}

// The spans of a plate along its own normal are one number up to rounding; its first corner is enough.
inline bool apart_along_normal(const PlacedPlate& a, const PlacedPlate& b, double touch) {
  const double at = a.normal.dot(a.corners[0]);
  return apart({at, at}, project(b, a.normal), touch * a.normal.norm());
}

// Directions of the edges: sides, and of a prism the way through it.
std::vector<Vec3> edge_directions(const PlacedPlate& plate) {
  std::vector<Vec3> directions;
  for (int i = 0; i < plate.count; ++i)
    directions.emplace_back(plate.corners[i + 1 == plate.count ? 0 : i + 1] - plate.corners[i]);
  if (plate.is_thick) directions.push_back(plate.normal);
  return directions;
}

std::vector<Vec3> face_normals(const PlacedPlate& plate) {
  std::vector<Vec3> normals{plate.normal};
  if (!plate.is_thick) return normals;
  const std::vector<Vec3> edges = edge_directions(plate);
  for (int i = 0; i < plate.count; ++i) normals.emplace_back(edges[i].cross(plate.normal));
  return normals;
}

bool prisms_penetrate(const PlacedPlate& a, const PlacedPlate& b, double touch) {
  const auto separates = [&](const Vec3& axis) {
    return apart(project_solid(a, axis), project_solid(b, axis), touch * axis.norm());
  };
  for (const PlacedPlate* plate : {&a, &b})
    for (const Vec3& normal : face_normals(*plate))
      if (separates(normal)) return false;
  const std::vector<Vec3> edges_a = edge_directions(a), edges_b = edge_directions(b);
  for (const Vec3& u : edges_a) {
    for (const Vec3& v : edges_b) {
      const Vec3 axis = u.cross(v);
      if (axis.squaredNorm() > kParallel * u.squaredNorm() * v.squaredNorm() && separates(axis)) return false;
    }
  }
  return true;
}

}  // namespace

bool penetrate(const PlacedPlate& a, const PlacedPlate& b, double touch) {
  if (a.is_thick || b.is_thick) return prisms_penetrate(a, b, touch);
  if (apart_along_normal(a, b, touch) || apart_along_normal(b, a, touch)) return false;
  for (int i = 0; i < a.count; ++i) {
    const Vec3 side_a = a.corners[i + 1 == a.count ? 0 : i + 1] - a.corners[i];
    for (int j = 0; j < b.count; ++j) {
      const Vec3 side_b = b.corners[j + 1 == b.count ? 0 : j + 1] - b.corners[j];
      const Vec3 axis = side_a.cross(side_b);
      const double length2 = axis.squaredNorm();
      if (length2 <= kParallel * side_a.squaredNorm() * side_b.squaredNorm()) continue;
      if (apart(project(a, axis), project(b, axis), touch * std::sqrt(length2))) return false;
    }
  }
  return true;
}

}  // namespace plico
