// Ridges: what sticks out of a part, told by the depth of its vertices below the part's hull.
#pragma once
#include <optional>
#include <vector>

#include "plico/segment/hull_depth.h"

namespace plico {

// Two ridges and the depth at which they hang together.
struct RidgePair {
  double saddle = 0;                 // the least depth that stays as long as both are in one part, units
  std::vector<char> side_of_vertex;  // of each patch vertex: 1 or 2 on the two ridges above the saddle, 0 elsewhere
};

// The ridges that join deepest; none when all vertices of the hull hang together at the surface, or less deep than
// `least`. A merge tree of the depths over the edges of the faces. O(n log n).
std::optional<RidgePair> deepest_ridges(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                                        double least);

}  // namespace plico
