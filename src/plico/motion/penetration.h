// Do two thin convex plates penetrate each other? The narrow phase of motion/collision.h.
#pragma once
#include "plico/base/vec.h"

namespace plico {

// A plate in space: `count` corners in cyclic order and the normal of its plane (any length but 0).
struct PlacedPlate {
  const Vec3* corners;
  int count;
  Vec3 normal;
};

// True when the plates share points and no translation by `touch` or less takes them apart (separating axes of their
// Minkowski difference: both normals and every product of two sides). Plates that only touch, at a corner, along a side
// or lying on each other in one plane, do not penetrate. O(count_a count_b (count_a + count_b)).
bool penetrate(const PlacedPlate& a, const PlacedPlate& b, double touch);

}  // namespace plico
