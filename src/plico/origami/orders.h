// Other orders of folding: where all creases together come no farther, some before the others may.
#pragma once
#include "plico/base/rng.h"
#include "plico/origami/approach.h"

namespace plico {

// From the end of `begun`, a state before it or flat, whichever is drawn: to where the sheet comes when the distance of
// each crease to its goal counts by a drawn factor, and from there as approach_goal. Deterministic; two approaches.
ContinuationResult approach_in_drawn_order(const Linkage& linkage, const FoldingPath& begun,
                                           const ApproachOptions& options, Rng rng, const Run& run = {});

}  // namespace plico
