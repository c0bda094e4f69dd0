#include "plico/mesh/point_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plico {
namespace {

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

SurfaceDistance::SurfaceDistance(const PolygonSoup& triangles) : soup_(triangles), tree_(boxes_of(triangles)) {}

double SurfaceDistance::operator()(const Vec3& p) const {
  return tree_.nearest(p, [&](int f) {
    const auto t = soup_.face(f);
    const std::array corners{soup_.points[t[0]], soup_.points[t[1]], soup_.points[t[2]]};
    const Vec3 weights = nearest_weights(corners, p);
    return (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - p).norm();
  });
}

}  // namespace plico
