// All ways to hang panels together as one tree whose motion is not refuted by samples: the answer to whether a small
// shape has a net that folds by a law at all.
#pragma once
#include <functional>
#include <vector>

#include "plico/base/run.h"
#include "plico/motion/branch_sampler.h"

namespace plico {

struct ClearTreesOptions {
  FoldingLaw law = FoldingLaw::Linear;
  double clearance = 0;          // units, greater than 0, as in motion/collision.h
  double touch = 0;              // units, the same
  int samples = 64;              // moments of the motion at which panels may not collide, at least 1
  long max_states = 10'000'000;  // of the search
};

struct ClearTrees {
  Ending ending = Ending::Exhausted;  // Found: `visit` returned true
  bool complete = false;              // every clear tree was visited: without one, every tree overlaps or collides
  long states = 0;
};

constexpr int kMostJoints = 64;  // pairs of sides that a kit may have here

// Calls visit(joined sides, both of a pair) for every spanning tree that is flat without overlap and free of collision
// at every sample, until it returns true. How two panels move against each other depends only on the tree path between
// them, so a path that makes its ends collide refutes every tree that holds it; joints are chosen one by one, and those
// that would complete such a path are barred at once. Exponential; a cube with six spikes (24 panels, 36 joints) takes
// 400,000 states, one second. Throws InvalidOption for kits with more than kMostJoints joints.
ClearTrees find_clear_trees(const PanelKit& kit, const ClearTreesOptions& options,
                            const std::function<bool(const std::vector<char>& joined)>& visit, const Run& run = {});

}  // namespace plico
