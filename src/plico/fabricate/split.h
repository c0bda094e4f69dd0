// Parts too large for a page: where to cut them so that their pieces fit.
#pragma once
#include <vector>

#include "plico/fabricate/net_sides.h"

namespace plico {

// Folds to cut so that every piece fits `room`: pieces are grown from the leaves of the tree of panels, the smallest
// first, and cut off when the next panel would make them too large. Of up to 32 roots of the tree, fewer for more than
// 300 panels, the one is taken that makes the fewest pieces, and of those the least area of their hulls. A panel that
// does not fit alone stays alone. One entry per edge, for cut_folds. O(n h^2).
std::vector<char> cuts_to_fit(const NetSides& sides, const Vec2& room);

}  // namespace plico
