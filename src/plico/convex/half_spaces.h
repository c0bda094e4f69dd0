// Small linear and closest-point problems: the best point of few unknowns below a few dozen planes.
// Source: R. Seidel, Small-dimensional linear programming and convex hulls made easy (1991).
#pragma once
#include <optional>
#include <span>

#include "plico/geom/convex3.h"

namespace plico {

// The points below all planes of `below`, and on those of `on` (at most three, not parallel).
struct HalfSpaceProblem {
  std::span<const Plane> below, on;
};

// The point of the ball that lies farthest against `uphill` (not zero), or none when nothing is left of the ball.
// Solve it about `center` in units of the shape at hand: what is tight within 1e-12 of the radius counts as kept.
std::optional<Vec3> lowest_point(const HalfSpaceProblem& problem, const Vec3& uphill, const Vec3& center,
                                 double radius);

// The point nearest to `target`, at most `radius` from it; none when there is no such point.
std::optional<Vec3> closest_point(const HalfSpaceProblem& problem, const Vec3& target, double radius);

// Both by adding planes in turn: where one cuts off the best point so far, the best one lies on it, and has one unknown
// less. The order is a fixed shuffle. Expected O(planes).

}  // namespace plico
