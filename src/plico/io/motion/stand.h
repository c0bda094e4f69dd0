// How a folding sheet is turned while it is shown, so that it begins as a sheet on the table and ends as a model that
// stands.
#pragma once
#include "plico/base/vec.h"

namespace plico {

struct Stand {
  Vec3 axis = Vec3::UnitZ();  // unit, through the origin
  double angle = 0;           // radians, right-handed, at time 1; in proportion before

  Eigen::Matrix3d at(double time) const { return rotation(axis, angle * time); }
};

}  // namespace plico
