// Limbs of a fine mesh, found on a coarse one: the shape is what counts, not how many faces it has.
#pragma once
#include <vector>

#include "plico/mesh/mesh.h"
#include "plico/segment/necks.h"

namespace plico {

inline constexpr int kCoarseFrom = 3000;  // faces

// cut_limbs() of the components of a mesh, then cut_by_thickness() (segment/thickness.h). One component of kCoarseFrom
// faces or more is simplified first; every face then goes with the nearest coarse one, loose pieces with their
// neighbours, and seams move to where they are cheapest. Nearly linear.
std::vector<int> cut_limbs_of(const Mesh& mesh, const DualGraph& graph, const NeckCutOptions& options = {},
                              const Run& run = {});

}  // namespace plico
