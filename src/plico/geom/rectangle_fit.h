// Does a convex shape fit a rectangle, turned as one likes?
#pragma once
#include <optional>
#include <span>

#include "plico/base/vec.h"

namespace plico {

// The angle by which a convex hull must be turned to fit a rectangle of size `room`, or nothing. Angles tried: those
// that lay an edge of the hull along a side of the room, and every 5 degrees. O(h^2).
std::optional<double> angle_that_fits(std::span<const Vec2> hull, const Vec2& room);

// The largest factor by which the hull can be scaled so that it fits the room, over the same angles.
double largest_scale(std::span<const Vec2> hull, const Vec2& room);

}  // namespace plico
