// How far apart line ends of a drawing may be and still be meant to meet: found from the drawing itself.
#pragma once
#include <vector>

#include "plico/fold/drawn_line.h"

namespace plico {

// Distances to try, the most likely first, in the drawing's unit. Slips of the hand are short, creases are long, and
// between the two there is a gap in the sorted distances of line ends from other lines: `customary` when it lies in
// such a gap, else the middles of the widest gaps, then `customary` and its double. None is longer than half of nearly
// all lines. `customary` is a fraction of `size`, the drawing's longer side. O(n log n) when lines are short against
// the drawing.
std::vector<double> merge_distances(const std::vector<DrawnLine>& lines, double size, double customary);

}  // namespace plico
