// Linear support vector machine in space: the plane that divides two sets of points with the widest soft margin.
#pragma once
#include <optional>
#include <vector>

#include "plico/geom/convex3.h"

namespace plico {

// The minimum of |c|^2 / 2 + penalty * sum of max(0, 1 - y (c.x + d)), y = -1 below and 1 above, up to a relative 1e-5:
// Newton on a smoothed loss whose width shrinks. None when no direction tells the sets apart (c = 0).
// Four unknowns, so a step is O(points); the optimum is unique in c and needs no library's stopping rule.
// The margin has the unit of the points: scale them first.
std::optional<Plane> svm_plane(const std::vector<Vec3>& below, const std::vector<Vec3>& above, double penalty);

}  // namespace plico
