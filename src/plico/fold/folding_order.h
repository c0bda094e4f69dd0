// Which creases move when: a motion as a person would tell it.
#pragma once
#include <vector>

#include "plico/fold/folding_path.h"

namespace plico {

struct FoldStep {
  double from = 0, to = 0;     // times
  std::vector<int> hinges;     // that move, ascending
  std::vector<double> angles;  // of these at the end of the step, radians
};

// Neighbouring stretches of the path in which the same creases move are one step. Moves below `still` radians in a
// stretch do not count. O(waypoints * hinges).
std::vector<FoldStep> folding_order(const FoldingPath& path, double still = 1e-6);

}  // namespace plico
