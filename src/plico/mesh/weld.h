// Points with equal coordinates.
#pragma once
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// For every point the first point with the same coordinates (itself, when there is none before it). Points that are not
// numbers equal nothing. O(n log n).
std::vector<int> welded_points(const std::vector<Vec3>& points);

}  // namespace plico
