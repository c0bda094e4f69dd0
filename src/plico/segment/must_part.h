// Faces that cannot be in one part: where a surface runs through itself, no net of both faces ever folds up.
#pragma once
#include <utility>
#include <vector>

#include "plico/segment/dual_graph.h"

namespace plico {

// Cuts parts (`part` of each face, 0..k-1, connected) until no part holds both faces of a pair. The pairs of a part are
// coloured with two colours, group by group, and one minimum cut takes the colours apart; pairs that no two colours can
// tell apart need a further cut. Pieces are then joined, across the dearest seam first, where no pair forbids it.
// O(groups cuts).
std::vector<int> part_pairs(const DualGraph& graph, std::vector<int> part,
                            const std::vector<std::pair<int, int>>& pairs);

}  // namespace plico
