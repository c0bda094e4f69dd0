// The walk around one real vertex or hole (eq. 2.1, read as R2), for the residual and its derivative.
#pragma once
#include <cmath>

#include "plico/base/libm.h"
#include "plico/origami/closure.h"

namespace plico {

// Where the walk has come to: a rigid motion. Around a vertex nothing shifts.
struct Walk {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vec3 shift = Vec3::Zero();
};

// Calls `visit(k, axis, point)` for the k-th crease as the walk so far has placed it.
template <class Visit>
Walk walk_around(const RealVertex& loop, const Configuration& config, Visit visit) {
  Walk walk;
  const bool shifts = loop.is_hole();
  for (std::size_t k = 0; k < loop.hinges.size(); ++k) {
    const Vec2& direction = loop.directions[k];
    const Vec3 axis = walk.turn * Vec3(direction.x(), direction.y(), 0);
    const Vec3 point =
        shifts ? Vec3(walk.turn * Vec3(loop.points[k].x(), loop.points[k].y(), 0) + walk.shift) : Vec3(Vec3::Zero());
    visit(k, axis, point);
    const Eigen::Quaterniond turn = quaternion(axis, config[loop.hinges[k]]);
    // Of unit length: the axes come from it, and around dozens of creases rounding would double at each.
    walk.turn = turn * walk.turn;
    walk.turn.coeffs() *= 1.5 - 0.5 * walk.turn.squaredNorm();
    if (shifts) walk.shift = point + turn * (walk.shift - point);
  }
  return walk;
}

// Axis times angle, angle in [0, pi]. acos of the trace loses half its digits near zero, where foldable states live.
inline Vec3 rotation_log(const Eigen::Quaterniond& q) {
  const double sine = q.vec().norm();
  if (sine == 0) return Vec3::Zero();
  const Vec3 axis = (q.w() < 0 ? -1.0 : 1.0) / sine * q.vec();
  return 2 * plico::atan2(sine, std::abs(q.w())) * axis;
}

// Writes num_equations() numbers.
inline void write_residual(const RealVertex& loop, const Walk& walk, double* out) {
  Eigen::Map<Vec3> turn(out);
  turn = rotation_log(walk.turn);
  if (!loop.is_hole()) return;
  Eigen::Map<Vec3> shift(out + 3);
  shift = walk.shift;
}

}  // namespace plico
