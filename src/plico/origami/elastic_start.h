// Out of flat where no first step leads: a foldable state some way off, and the way back from it.
#pragma once
#include "plico/origami/approach.h"

namespace plico {

struct ElasticOptions {
  double share = 0.1;         // of the goal, that the creases are pulled to; in (0, 1]
  bool may_turn_back = true;  // when no state keeps all creases on the sides of their goals, take one that does not
  double softest = 1e-9;      // stiffness of the creases at the end, against that of the loops; in (0, 1)
};

// Flat is where all ways to fold meet, and near it the loops say nothing to first order. So the creases are pulled to a
// share of their goals as springs are, as stiff as the loops at first, then ever softer, until the loops close: the way
// simulators of elastic sheets find a state, which we then project. The state is folded back to flat as approach_goal
// does; that motion, reversed, is the path. With options.keep_sides creases of the state do not turn against their
// goals if such a state is found. Without a state that closes, is free of collision and unfolds, the path is flat
// alone. Deterministic. About 60 factorizations, then O(waypoints) projections and collision checks.
ContinuationResult start_elastically(const Linkage& linkage, const ElasticOptions& elastic,
                                     const ApproachOptions& options = {}, const Run& run = {});
inline ContinuationResult start_elastically(const CreasePattern& sheet, const ElasticOptions& elastic,
                                            const ApproachOptions& options = {}, const Run& run = {}) {
  return start_elastically(make_linkage(sheet), elastic, options, run);
}

}  // namespace plico
