// How deep the vertices of some faces lie below their hull: the measure of how far a part is from convex.
#pragma once
#include <optional>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// The vertices of some faces, each once.
struct PatchVertices {
  std::vector<int> vertex;    // of the mesh, ascending
  std::vector<double> depth;  // of each: to the nearest plane of a facet of the hull, units; 0 on the hull

  double deepest() const;         // 0 when there is no vertex
  int at(int mesh_vertex) const;  // the position of a vertex of these faces in `vertex`; O(log n)
};

// Faces that span no volume are flat, and 0 deep everywhere. O(n log n + n h) for h facets of the hull.
PatchVertices hull_depths(const Mesh& mesh, const std::vector<int>& faces);

// The depth of the deepest vertex, or nothing when one is deeper than `bound`: that is soon seen.
std::optional<double> depth_within(const Mesh& mesh, const std::vector<int>& faces, double bound);

}  // namespace plico
