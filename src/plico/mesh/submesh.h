// Some faces of a mesh as a mesh of their own.
#pragma once
#include <vector>

#include "plico/mesh/measures.h"
#include "plico/mesh/mesh.h"

namespace plico {

struct Submesh {
  Mesh mesh;
  std::vector<int> face;  // of the whole mesh, for each face of this one, ascending
  std::vector<int> edge;  // of the whole mesh, for each edge of this one
};

// The faces of component `which`, in order, with all vertices kept. O(n).
Submesh component(const Mesh& mesh, const Components& components, int which);

// These faces, each at most once, in ascending order, with the vertices they use. Where they meet in a vertex but not
// around it, each fan gets a vertex of its own, so every set of faces makes a mesh. O(n log n) of the faces.
Submesh submesh(const Mesh& mesh, std::vector<FaceId> faces);

}  // namespace plico
