// A pile of thick squares unrolled straight into the shape: panels 0 .. k stand in the shape, the rest is one rigid
// tower on panel k, and a step opens the next one to three hinges from +-180 degrees to their angles in the shape.
// Steps are searched depth first, straight in the angles or on a grid of them, and every one is proven free at every
// moment before it is taken: samples lie (of 1,517 steps accepted 7.5 degrees apart 127 collided in between). Ours;
// [Xi17] leaves the motion of thick chains open.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/linkage.h"

namespace plico {

struct PeelOptions {
  double air = 0.01;    // each face of a panel moves inwards by this share of its thickness, in (0, 0.5)
  int widest = 3;       // hinges that a step may open together, 1 to 3
  long nodes = 100000;  // of grids, looked at in the whole search, at least 0
};

// One step: what the hinges first, first + 1 ... go through, one row a state; the first row is the pile's.
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
