#include "plico/unfold/count_cuts.h"

#include <algorithm>
#include <cmath>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kTrifle = 1e-6;  // radians

// Groups of at most a full turn that the faces around a vertex fall into.
long num_groups(const Mesh& mesh, VertexId v) {
  return std::max(1L, static_cast<long>(std::ceil((angle_sum(mesh, v) - kTrifle) / (2 * kPi))));
}

}  // namespace

CutCount count_cuts(const Mesh& mesh) {
  CutCount count;
  long inner_edges = 0, inner_vertices = 0;
  for (EdgeId e : mesh.edges()) inner_edges += mesh.is_boundary(e) ? 0 : 1;
  count.cut_ends = 2 * (inner_edges - mesh.num_faces() + 1);
  for (VertexId v : mesh.vertices()) {
    if (is_boundary(mesh, v) || !mesh.halfedge(v).valid()) continue;
    ++inner_vertices;
    count.needed += num_groups(mesh, v);
  }
  const auto loops = boundary_loops(mesh);
  const long least = inner_vertices > 0 || loops.size() > 1 ? 1 : 0;
  for (const std::vector<VertexId>& loop : loops) {
    long needed = 0;
    for (VertexId v : loop) needed += num_groups(mesh, v) - 1;
    count.needed += std::max(needed, least);
  }
  return count;
}

}  // namespace plico
