// The way of one step of a peel on a grid of its angles.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/stack/peel_step.h"

namespace plico {

// From the step's start to its end over multiples of 15 degrees, shortest first (A*), every piece of the way proven
// free: ways are found over states that are free, then proven; a piece that fails is barred and the search goes on.
// Empty when there is none, `nodes` are used up, or the run is over.
std::vector<Angles3> find_on_grid(const PeelWindow& window, long& nodes, long& intervals, const Run& run);

}  // namespace plico
