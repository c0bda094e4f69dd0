// Whether a small surface of squares has a Hamiltonian cycle, or a path, at all: the answer where the search finds
// none.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/stack/path_exchange.h"

namespace plico {

enum class Walk { Cycle, Path };

struct WalkDecision {
  Ending ending = Ending::Exhausted;  // Found: there is one; Exhausted: it is proven that there is none
  std::vector<int> squares;           // in the order of the walk; empty when there is none
  int cuts = 0;                       // conditions added on the way: some part of the surface must not be left alone
};

// A SAT solver (CaDiCaL) chooses two of the four sides of every square; a path may choose one at its two ends. As long
// as that gives several walks, each of them must be left over some side, and the solver is asked again. A proof that
// there is none rests on the solver. Exponential: for some hundreds of squares. Throws InvalidInput when a neighbour
// does not name its neighbour back.
WalkDecision decide_walk(const SquareGraph& graph, Walk walk, const Run& run = {});

}  // namespace plico
