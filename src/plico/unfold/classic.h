// Nets by the classic heuristics alone: trees of least weight over several directions.
#pragma once
#include <cstdint>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/unfold/heuristics.h"

namespace plico {

struct ClassicOptions {
  std::uint64_t seed = 1;
  Heuristic heuristic = Heuristic::SteepestEdge;
  int directions = 20;  // at least 1
};
void check(const ClassicOptions& options);  // throws InvalidOption

struct ClassicResult {
  Ending ending = Ending::Exhausted;  // Found when a direction gave a net for every component
  FoldForest forest;                  // never overlaps: the best tree, cut into parts where it did
  int parts = 0;
  int overlaps = 0;  // overlapping pairs in the best trees, before cutting
};

// The tree with the fewest overlaps among `directions` random ones, for every component. O(directions n log n).
ClassicResult classic_net(const Mesh& mesh, const ClassicOptions& options = {}, const Run& run = {});

}  // namespace plico
