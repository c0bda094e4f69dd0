// Our own search for a net, the default of `plico unfold`: grow a tree that avoids overlaps while it can, then cut off
// subtrees of panels that overlap and hang them elsewhere, until none does. Overlaps that no single step removes weigh
// more and more until something else gives way (breakout local search, Morris 1993), with a short tabu on folds just
// cut.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"
#include "plico/unfold/heuristics.h"

namespace plico {

struct SearchOptions {
  std::uint64_t seed = 1;                 // same mesh, same options: same result on every machine and thread count
  int starts = 2;                         // grown trees of which the one with the fewest overlaps is taken; at least 1
  std::optional<Heuristic> grow_by = {};  // of all starts; empty: they take turns, minimum-perimeter first
  int tabu_tenure = 12;  // steps for which a fold just cut is not made again, at least, and less than twice that
  int effort = 400;      // panels looked at in a step before the best hanging found so far is taken; at least 1. From
                         // 2,000 panels on a quarter of it, and big branches are tried elsewhere in between
  long max_steps = -1;   // -1: 10,000 and 100 more a panel, for each component
};
void check(const SearchOptions& options);  // throws InvalidOption naming field, value and range

struct SearchResult {
  Ending ending = Ending::Exhausted;
  FoldForest forest;  // never overlaps; one part per component of the mesh exactly when ending is Found
  int parts = 0;
  int start_overlaps = 0;  // overlapping pairs of panels in the trees that the search set out from
  long steps = 0;          // subtrees hung elsewhere; as max_steps it repeats a run that was timed out
  // No net exists: its vertices need more cuts than a net has (count_cuts.h), or every spanning tree was tried (small
  // meshes only, see exhaust.h).
  bool proven_impossible = false;
  // Pairs of mesh faces that still overlapped when the search ended and were then cut apart.
  std::vector<std::pair<int, int>> in_the_way;
};

// One net for every component of the mesh. When none is found, the best tree seen is cut into few parts.
// Memory is linear; the time of a step does not depend on the size of the mesh but on `effort`.
SearchResult find_net(const Mesh& mesh, const SearchOptions& options = {}, const Run& run = {});

}  // namespace plico
