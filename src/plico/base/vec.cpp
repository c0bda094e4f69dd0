#include "plico/base/vec.h"

namespace plico {

Pose rotation_about(const Vec3& from, const Vec3& to, double angle) {
  const Eigen::AngleAxisd turn(angle, (to - from).normalized());
  Pose pose = Pose::Identity();
  pose.linear() = turn.toRotationMatrix();
  pose.translation() = from - pose.linear() * from;
  return pose;
}

}  // namespace plico
