// Overlaps of a whole unfolding, for searches and heuristics (rounded; the exact judge is verify/net.h).
#pragma once
#include <utility>
#include <vector>

#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"

namespace plico {

// Places every face of a connected mesh along a spanning tree: one Vec2 per halfedge, face 0 at rest. O(n).
std::vector<Vec2> lay_panels(const FlatFaces& faces, const FoldForest& tree);

// Pairs of panels that share interior points, lower face first, in order of the higher. O(n + pairs) for faces of
// similar size.
std::vector<std::pair<int, int>> overlapping_pairs(const FlatFaces& faces, const std::vector<Vec2>& at);

}  // namespace plico
