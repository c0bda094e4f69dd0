// Instead of CaDiCaL: gives up at once, as the solver does at a time limit.
#include "plico/stack/decide_walk.h"

#include "plico/base/error.h"

namespace plico {

WalkDecision decide_walk(const SquareGraph& graph, Walk, const Run&) {
  check(graph);
  if (graph.size() == 0) throw InvalidInput("stack/empty", "there is no square");
  WalkDecision decision;
  decision.ending = Ending::TimedOut;
  return decision;
}

}  // namespace plico
