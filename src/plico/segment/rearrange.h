// Cuts that are the best together, where cut_at_necks() takes the best of every moment: as many parts, in other places.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/segment/dual_graph.h"
#include "plico/segment/necks.h"

namespace plico {

// Cuts the parts that are there (`part` of each face, 0..k-1, connected) as options say. First as many necks as
// cut_at_necks() would cut; then four more, joined again where that costs least; then single seams are exchanged for
// others while the sum over all seams of cost over area of the smaller neighbour to the power 0.8 falls. The new parts
// stand only when they are clearly better by that sum and their seams not much dearer. Where a number is asked for
// (worst_score infinite) and necks run out, short seams do: their score forgives small sides. At last seams settle
// (segment/settle.h). Parts that were there are never joined. A run that is over leaves fewer parts. Tens of
// best_neck().
std::vector<int> cut_limbs(const DualGraph& graph, const std::vector<int>& part, const NeckCutOptions& options = {},
                           const Run& run = {});

}  // namespace plico
