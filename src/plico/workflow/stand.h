// A net folds around the panel that stays put; its model is looked at standing on its feet.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/fold/unfolding.h"
#include "plico/io/motion/stand.h"
#include "plico/mesh/mesh.h"

namespace plico {

// The turn of the whole sheet that makes the folded model of one part stand with axis `up` of its mesh along z; none
// when the net has several parts, which fold around panels of their own.
Stand stand_of(const Unfolding& net, const Linkage& linkage, const Mesh& mesh, char up);

// Poses in the frame of a mesh, turned so that its axis `up` is z.
std::vector<Pose> standing(std::vector<Pose> poses, char up);

}  // namespace plico
