// A start for searches: a spanning tree grown panel by panel that avoids overlaps while it can.
#pragma once
#include <vector>

#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"

namespace plico {

// Grows the net of a connected mesh from `seed_face` across the lightest dual edge (`weights`, one per mesh edge) by
// which a panel fits without overlap (Prim's algorithm with a test). When no panel fits any more, one is placed where
// it overlaps the fewest, and growing goes on. O(n log n) for faces of similar size.
FoldForest grow_tree(const FlatFaces& faces, const std::vector<double>& weights, int seed_face);

}  // namespace plico
