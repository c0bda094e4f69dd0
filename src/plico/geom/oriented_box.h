// Boxes that stand askew in space, and how far apart two of them are.
#pragma once
#include <array>

#include "plico/base/vec.h"

namespace plico {

struct OrientedBox {
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: unit vectors along the sides
  Vec3 half = Vec3::Zero();                            // half the length of each side
};

// The box `local` carried along by a rigid motion.
OrientedBox placed(const OrientedBox& local, const Pose& pose);

std::array<Vec3, 8> corners_of(const OrientedBox& box);

// The widest gap between the shadows of two boxes along the normals of their sides and of pairs of edges: at most their
// distance when positive; when negative they share interior points (but for rounding), as deep as that at most. O(1).
double gap(const OrientedBox& a, const OrientedBox& b);

// Distance of a point from the box, 0 inside.
double distance(const OrientedBox& box, const Vec3& point);

}  // namespace plico
