// The lines that a drawing means: edges that go straight on through a vertex.
#pragma once
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

// Vertices of each line of two edges or more, from end to end, ascending by first edge. Borders and cuts continue
// borders and cuts, creases continue creases. A vertex is on the line when it is within `off` units of the segment
// between its neighbours there, and no other edge goes on straighter. A closed line has its first vertex only once.
// O(sum of squared degrees).
std::vector<std::vector<int>> straight_lines(const CreasePattern& sheet, double off);

}  // namespace plico
