// Cuts of some faces of a mesh in two.
#pragma once
#include <vector>

#include "plico/segment/hull_depth.h"

namespace plico {

// What a unit of seam costs.
struct SeamWeight {
  double valley_fall = 0.35;  // radians of a valley in which the cost falls to 1/e; 0: angles do not count
  double deep = 0.7;          // how much less a seam costs at the deepest vertex than on the hull, in [0, 1)
};

enum class Side : char { Free, First, Second };
bool both_given(const std::vector<Side>& side);  // some First and some Second

// The cheapest cut between the faces that are given to a side: every face First or Second. `faces` are ascending, one
// entry of `given` each, both sides among them; `patch` has the depths of their vertices, or nothing when depth does
// not count. One minimum cut.
std::vector<Side> cut_patch(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                            std::vector<Side> given, const SeamWeight& weight);

// Cuts a part at its deepest fault, so that both sides have faces:
//   - a minimum cut between the two ridges that join deepest (segment/ridges.h), when that is below `least_saddle`;
//   - else, in a dent or a tunnel, a minimum cut near the deepest vertex, across the longest side of the part's box;
//   - else in halves by the centres of the faces.
// At least two faces.
std::vector<Side> part_at_fault(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                                double least_saddle, const SeamWeight& weight);

// The connected pieces of both sides, each ascending, by first face. O(n log n).
std::vector<std::vector<int>> connected_sides(const Mesh& mesh, const std::vector<int>& faces,
                                              const std::vector<Side>& side);

}  // namespace plico
