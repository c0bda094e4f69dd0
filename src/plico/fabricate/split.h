// Parts too large for a page: does a part fit, and where to cut it so that its pieces do.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "plico/fabricate/net_sides.h"

namespace plico {

// The angle by which a convex hull must be turned to fit a rectangle of size `room`, or nothing. Angles tried: those
// that lay an edge of the hull along a side of the room, and every 5 degrees. O(h^2).
std::optional<double> angle_that_fits(std::span<const Vec2> hull, const Vec2& room);

// The largest factor by which the hull can be scaled so that it fits the room, over the same angles.
double largest_scale(std::span<const Vec2> hull, const Vec2& room);

// Folds to cut so that every piece fits `room`: pieces are grown from the leaves of the tree of panels, the smallest
// first, and cut off when the next panel would make them too large. Of up to 32 roots of the tree, fewer for more than
// 300 panels, the one is taken that makes the fewest pieces, and of those the least area of their hulls. A panel that
// does not fit alone stays alone. One entry per edge, for cut_folds. O(n h^2).
std::vector<char> cuts_to_fit(const NetSides& sides, const Vec2& room);

}  // namespace plico
