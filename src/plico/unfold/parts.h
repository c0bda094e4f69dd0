// From a tree whose panels overlap to few parts whose panels do not.
#pragma once
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"

namespace plico {

// Cuts folds of `tree`, a spanning tree of the connected mesh of `faces`, until no part overlaps itself, then joins
// parts across other edges wherever they fit. Overlapping pairs are taken from the deepest common ancestor up and
// parted there (the tree multicut of Garg, Vazirani and Yannakakis 1997: at most twice the fewest cuts of this tree).
// The result is a forest without overlap; one part when `tree` is a net already.
// O(n + pairs * depth + joins).
FoldForest part_overlaps(const FlatFaces& faces, const FoldForest& tree);

// Cuts one fold between the two panels of every pair that `forest` still holds together: the one that carries the
// smaller of their branches. For pairs that a judge finds in the finished layout. O(n + pairs * depth).
void part_pairs(const Mesh& mesh, FoldForest& forest, const std::vector<std::pair<int, int>>& pairs);

}  // namespace plico
