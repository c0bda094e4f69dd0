// How far apart two convex plates are, or how deep they penetrate: the measure behind the proof in verify/path.h.
#pragma once
#include <span>

#include "plico/base/vec.h"

namespace plico {

// `value` > 0: the distance of the plates. `value` <= 0: they share points, and the shortest translation that takes
// them apart is -value long (0 when they only touch, or lie on each other in one plane). `direction` is a unit vector
// along which `a` lies ahead of `b` by `value`: min of direction.x over a, minus max over b.
struct Separation {
  double value = 0;
  Vec3 direction = Vec3::UnitX();
};

// Corners in cyclic order, at least three, in one plane, convex. By closest features: every side against every side,
// every corner against the other plate. O(n m).
Separation separation(std::span<const Vec3> a, std::span<const Vec3> b);

// The same for prisms: corners of one end in cyclic order, then those of the other end in the same order. By separating
// axes, so a positive `value` may be less than the distance, but is positive whenever that is. O(n m (n + m)).
Separation separation_of_prisms(std::span<const Vec3> a, std::span<const Vec3> b);

// min of direction.x over a, minus max of direction.x over b.
double lead(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& direction);

}  // namespace plico
