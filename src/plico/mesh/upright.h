// Which way is up? Files do not say, and programs disagree: y for those that draw, z for those that build.
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

// 'y' or 'z'. Several pieces stand along the axis along which all of them begin at one height and do not all end at
// one. What has equal halves left and right of one of the two axes stands along the other: animals, people, furniture.
// Otherwise it is the axis on whose lowest points the shape stands best; 'y' when nothing speaks for z. O(n log n).
char guessed_up(const Mesh& mesh);

// The rotation that carries a model with this axis up to one with z up; the identity for 'z'.
Eigen::Matrix3d z_up_from(char up);

}  // namespace plico
