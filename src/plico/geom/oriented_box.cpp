#include "plico/geom/oriented_box.h"

#include <algorithm>
#include <cmath>

namespace plico {

OrientedBox placed(const OrientedBox& local, const Pose& pose) {
  return {pose * local.center, pose.linear() * local.axes, local.half};
}

std::array<Vec3, 8> corners_of(const OrientedBox& box) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 at(i & 1 ? box.half.x() : -box.half.x(), i & 2 ? box.half.y() : -box.half.y(),
                  i & 4 ? box.half.z() : -box.half.z());
    corners[i] = box.center + box.axes * at;
  }
  return corners;
}

double gap(const OrientedBox& a, const OrientedBox& b) {
  // Everything as `a` sees it.
  const Eigen::Matrix3d turn = a.axes.transpose() * b.axes;
  const Vec3 off = a.axes.transpose() * (b.center - a.center);
  const Eigen::Matrix3d size = turn.cwiseAbs();
  double widest = (off.cwiseAbs() - a.half - size * b.half).maxCoeff();
  widest = std::max(widest, ((turn.transpose() * off).cwiseAbs() - b.half - size.transpose() * a.half).maxCoeff());
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const double squared = 1 - turn(i, j) * turn(i, j);  // of the length of the product of the two edges
      if (squared < 1e-6) continue;                        // edges side by side: the normals have told
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double between = std::abs(off[i2] * turn(i1, j) - off[i1] * turn(i2, j));
      const double sizes =
          a.half[i1] * size(i2, j) + a.half[i2] * size(i1, j) + b.half[j1] * size(i, j2) + b.half[j2] * size(i, j1);
      widest = std::max(widest, (between - sizes) / std::sqrt(squared));
    }
  }
  return widest;
}

double distance(const OrientedBox& box, const Vec3& point) {
  const Vec3 beyond = (box.axes.transpose() * (point - box.center)).cwiseAbs() - box.half;
  return beyond.cwiseMax(0).norm();
}

}  // namespace plico
