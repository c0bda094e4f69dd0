// One component of a mesh as a mesh of its own.
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

}  // namespace plico
