// Marks that children build by: a square where to begin, and a short stroke on both edges of a seam at the same point.
#pragma once
#include "plico/fabricate/net_sides.h"
#include "plico/fold/page_layout.h"

namespace plico {

struct MarkOptions {
  bool start = false;  // a square at one vertex of each part where two edges that meet begin
  bool seam = false;   // strokes across both edges of each seam that meet at the same point
};

// Adds marks inside the panels of the placed parts of `layout`, whose net is that of `sides`. O(n).
void add_marks(PageLayout& layout, const NetSides& sides, const std::vector<std::vector<std::vector<int>>>& outlines,
               const MarkOptions& options);

}  // namespace plico
