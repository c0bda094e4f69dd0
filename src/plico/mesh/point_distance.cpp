#include "plico/mesh/point_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plico {
namespace {

// Of a point from a triangle (Ericson 2005, 5.1.5, by the regions of its corners, edges and face).
double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto to_segment = [&](const Vec3& u, const Vec3& v) {
    const Vec3 along = v - u;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - u).dot(along) / length, 0.0, 1.0) : 0;
    return (p - u - t * along).norm();
  };
  const Vec3 n = (b - a).cross(c - a);
  const bool above = n.squaredNorm() > 0 && n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                     n.dot((a - c).cross(p - c)) >= 0;
  if (above) return std::abs(n.dot(p - a)) / n.norm();
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

std::vector<Eigen::AlignedBox3d> boxes_of(const PolygonSoup& soup) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int f = 0; f < soup.num_faces(); ++f) {
    Eigen::AlignedBox3d box;
    for (int v : soup.face(f)) box.extend(soup.points[v]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const PolygonSoup& triangles) : soup_(triangles), tree_(boxes_of(triangles)) {}

double SurfaceDistance::operator()(const Vec3& p) const {
  return tree_.nearest(p, [&](int f) {
    const auto t = soup_.face(f);
    return distance_to_triangle(p, soup_.points[t[0]], soup_.points[t[1]], soup_.points[t[2]]);
  });
}

}  // namespace plico
