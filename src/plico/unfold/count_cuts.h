// Meshes that have no net for a reason that can be counted: too few cuts for what their vertices need.
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

struct CutCount {
  long cut_ends = 0;  // a net in one piece cuts (edges with two faces) - (faces) + 1 of them, and each cut has two ends
  long needed = 0;    // at the vertices and boundary loops, at least
  bool refutes() const { return needed > cut_ends; }
};

// `mesh` must be connected. The faces around a vertex that hang together lie flat side by side, so they have at most a
// full turn of corners: an inner vertex with the angle sum S is the end of at least ceil(S / 2 pi) cuts, and of one; a
// boundary vertex of one fewer, and none. The cuts join all inner vertices and boundary loops, so one ends at each loop
// at least where there is anything else. Sums within 1e-6 radians of full turns count for the smaller number, as the
// judge lets panels overlap by a trifle. O(faces).
CutCount count_cuts(const Mesh& mesh);

}  // namespace plico
