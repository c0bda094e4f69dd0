// How thick a shape is below its surface: thin where a limb is, also where no valley tells that it begins.
#pragma once
#include <vector>

#include "plico/mesh/mesh.h"
#include "plico/segment/necks.h"

namespace plico {

// The shape diameter of every face (Shapira, Shamir and Cohen-Or 2008), units: the median distance, over rays in a cone
// into the shape, to where the surface is left again; then smoothed with the neighbours' by their areas. 0 where no ray
// hits the inside of the surface, as on flat sheets. In proportion to the size. O(n log n).
std::vector<double> thickness(const Mesh& mesh);

// Cuts parts (`part` of each face, 0..k-1, connected) on where seams no longer find a valley: at necks of the graph
// whose seams are cheaper where the thickness changes (DualGraph::discount). Nothing is cut when a number of parts is
// asked for (worst_score infinite).
std::vector<int> cut_by_thickness(const Mesh& mesh, const DualGraph& graph, std::vector<int> part,
                                  const NeckCutOptions& options, const Run& run = {});

}  // namespace plico
