#include "plico/base/vec.h"

#include <cmath>

#include "plico/base/libm.h"

namespace plico {

// Rodrigues: cos I + (1 - cos) a a^T + sin [a]x.
Eigen::Matrix3d rotation(const Vec3& axis, double angle) {
  const double cosine = plico::cos(angle);
  const Vec3 s = plico::sin(angle) * axis, c = (1 - cosine) * axis;
  const double xy = c.x() * axis.y(), xz = c.x() * axis.z(), yz = c.y() * axis.z();
  Eigen::Matrix3d turn;
  turn << c.x() * axis.x() + cosine, xy - s.z(), xz + s.y(),  //
      xy + s.z(), c.y() * axis.y() + cosine, yz - s.x(),      //
      xz - s.y(), yz + s.x(), c.z() * axis.z() + cosine;
  return turn;
}

Eigen::Matrix2d rotation(double angle) {
  const double s = plico::sin(angle), c = plico::cos(angle);
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  return turn;
}

Eigen::Quaterniond quaternion(const Vec3& axis, double angle) {
  const Vec3 v = plico::sin(angle / 2) * axis;
  return {plico::cos(angle / 2), v.x(), v.y(), v.z()};
}

Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share) {
  const double dot = a.dot(b), cosine = std::abs(dot);
  double of_a = 1 - share, of_b = share;
  if (cosine < 1 - 2.3e-16) {  // otherwise the arc is a point, and the chord is as good
    const double arc = plico::acos(cosine), sine = plico::sin(arc);
    of_a = plico::sin((1 - share) * arc) / sine;
    of_b = plico::sin(share * arc) / sine;
  }
  if (dot < 0) of_b = -of_b;
  return Eigen::Quaterniond(of_a * a.coeffs() + of_b * b.coeffs());
}

Pose rotation_about(const Vec3& from, const Vec3& axis, double angle) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation(axis, angle);
  pose.translation() = from - pose.linear() * from;
  return pose;
}

}  // namespace plico
