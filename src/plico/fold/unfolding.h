// A mesh cut open along edges and laid flat, one connected part per tree of panels. A *net* is an unfolding of one part
// in which no two panels share an interior point (R15).
#pragma once
#include <vector>

#include "plico/fold/crease_pattern.h"
#include "plico/mesh/mesh.h"

namespace plico {

// Which edges of a mesh stay folds; all other edges are cut. One entry per mesh edge. A valid forest crosses no
// boundary edge and closes no cycle of the dual graph.
struct FoldForest {
  std::vector<char> is_fold;
  bool operator==(const FoldForest&) const = default;
};

struct Unfolding {
  CreasePattern sheet;         // flat, in the mesh's unit; panel f has the corners of mesh face mesh_face[f], in order
  std::vector<int> mesh_face;  // of each panel
  std::vector<int> mesh_vertex;  // of each net vertex
  std::vector<int> mesh_edge;    // of each sheet edge
  std::vector<int> mate;         // of each sheet edge: the edge it is glued to, -1 for none
  std::vector<int> part;         // of each panel, 0..k-1
  int num_parts() const;
};

// Lays the trees of `forest` flat: panel i is mesh face i; each part starts at its lowest face, whose first side lies
// along +x from the origin, and the parts stand side by side in x, a hundred a row. Edges are numbered in the order of
// panels and sides. Positions are rigid motions of the mesh's faces, composed along the tree: a relative rounding error
// of about 1e-16 per step. Throws InvalidInput when the forest has a cycle or crosses a boundary edge. O(n).
Unfolding lay_flat(const Mesh& mesh, const FoldForest& forest);

// The corners of a face in its own plane: first corner at the origin, first side along +x, counter-clockwise.
std::vector<Vec2> flat_corners(const Mesh& mesh, FaceId face);

// The forest of an unfolding; lay_flat(mesh, forest_of(...)) is the same net up to rigid motions of its parts.
FoldForest forest_of(const Mesh& mesh, const Unfolding& unfolding);

}  // namespace plico
