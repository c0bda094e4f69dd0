// A pile of thick squares unrolled straight into the shape: panels 0 .. k stand in the shape, the next one to four
// hinges are open in between, the rest is one rigid tower at the end of that arm. So the tower need not stand upon
// panel k: the arm holds it where there is room, and brings the next panel to its place. Searched depth first over k,
// and on a grid of the open angles; every piece is proven free at every moment before it is taken: samples lie (of
// 1,517 steps accepted 7.5 degrees apart 127 collided in between). Ours; [Xi17] leaves the motion of thick chains open.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/linkage.h"

namespace plico {

struct PeelOptions {
  double air = 0.01;     // each face of a panel moves inwards by this share of its thickness, in (0, 0.5)
  int widest = 4;        // hinges that may be open at a time, 1 to 4
  int step = 90;         // degrees between angles, a divisor of 90
  long nodes = 1000000;  // states looked at in the whole search, at least 0
  long patience = 3000;  // and since the longest prefix grew, at least 1: another chain is tried sooner than all ways
};

// One step: hinge `first` comes to its angle in the shape. One row a state: of the hinges first, first + 1 ...; the
// first row is where the step before left them. All others beyond are as in the pile.
struct PeelStep {
  int first = 0;
  std::vector<Eigen::VectorXd> angles;  // radians
};

struct Peel {
  std::vector<PeelStep> steps;  // in order; of the longest prefix when it is not whole
  int opened = 0;               // hinges that stand as in the shape
  bool whole = false;
  long nodes = 0, intervals = 0;  // looked at
};

// `chain` has hinge i between the equal square panels i and i + 1, panel 0 at rest, thick hinges (Hinge::roll), and the
// shape as its goal. In the pile hinge i stands at `sign` * 180 degrees times (-1)^i, `sign` 1 or -1. Throws
// InvalidOption.
Peel peel(const Linkage& chain, int sign, const PeelOptions& options = {}, const Run& run = {});

}  // namespace plico
