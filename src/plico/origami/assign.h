// Mountains and valleys for creases that were drawn without: such that the sheet folds flat around every vertex.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/crease_pattern.h"

namespace plico {

inline constexpr int kMostAssigned = 16;  // mountains, valleys and unassigned creases at one vertex

struct AssignOptions {
  double angle = 5e-3;  // radians: what Kawasaki's sums may be off by, and sectors that count as equal; above 0
  std::function<bool(const CreasePattern&)> suits = {};  // what else is asked of an assignment; none: nothing
  int max_refused = 200;                                 // assignments that do not suit, at least 0
};

struct AssignResult {
  Ending ending = Ending::Exhausted;  // Exhausted: there is no such assignment
  CreasePattern sheet;                // Found: with every crease assigned; otherwise as given
  int assigned = 0;                   // creases that had no letter
  bool suits = true;                  // Found: false when none of those tried did; then it is the first of them
  std::vector<int> vertices;          // Exhausted: one that cannot fold flat, or some that cannot together
  std::string why;                    // Exhausted: the reason, a sentence about these
};

// Does a vertex with these sectors (radians, the i-th from crease i to the next) and these folds (+1 valley, -1
// mountain) fold flat by itself? Exact for sectors that are equal or differ by more than `angle`: runs of least sectors
// are crimped until all are equal, where mountains and valleys must differ by two. This holds Kawasaki's, Maekawa's and
// the big-little-big conditions in it. Source: [BH96]. O(degree^2).
bool folds_flat(std::vector<double> sectors, std::vector<int> folds, double angle = 5e-3);

// Gives every unassigned crease a mountain or a valley of 180 degrees such that each vertex inside the sheet folds flat
// by itself; mountains and valleys that are there stay as they are, flat creases stay flat. Whether the folded sheet
// has an order of its layers is another question. By SAT, with the assignments that a vertex forbids as clauses.
// Deterministic. Throws InvalidInput when a vertex has more than kMostAssigned creases.
AssignResult assign_creases(const CreasePattern& sheet, const AssignOptions& options = {}, const Run& run = {});

}  // namespace plico
