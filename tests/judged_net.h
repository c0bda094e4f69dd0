// What the judge says of the net that a forest makes.
#pragma once
#include "plico/fold/unfolding.h"
#include "plico/verify/net.h"

namespace plico {

inline NetVerdict judge(const Mesh& mesh, const FoldForest& forest) { return verify_net(lay_flat(mesh, forest), mesh); }

}  // namespace plico
