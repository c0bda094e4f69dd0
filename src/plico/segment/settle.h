// Seams that were each cut by itself go to where they are cheapest between the parts there are now.
#pragma once
#include <vector>

#include "plico/segment/dual_graph.h"
#include "plico/segment/necks.h"

namespace plico {

// Moves the seam between every two neighbours to the minimum cut in a band around it, where length counts besides what
// hides a seam: of two valleys the shorter. Parts stay connected, none becomes smaller than min_area, and no seam
// moves between parts that come from different parts of `start`. Two minimum cuts a pair of neighbours, about.
void settle_seams(const DualGraph& graph, const std::vector<int>& start, std::vector<int>& part,
                  const NeckOptions& options = {});

}  // namespace plico
