// Do two convex plates, thin or thick, penetrate each other? The narrow phase of motion/collision.h.
#pragma once
#include "plico/base/vec.h"

namespace plico {

// A plate in space: `count` corners in cyclic order and the normal of its plane (any length but 0). A thick one is the
// prism between those corners and as many that follow them, which lie straight ahead along the normal.
struct PlacedPlate {
  const Vec3* corners;
  int count;
  Vec3 normal;
  bool is_thick = false;
};

// True when the plates share points and no translation by `touch` or less takes them apart (separating axes of their
// Minkowski difference: the normals of faces and every product of two edges). Plates that only touch, at a corner,
// along a side or lying on each other in one plane, do not penetrate. O(count_a count_b (count_a + count_b)).
bool penetrate(const PlacedPlate& a, const PlacedPlate& b, double touch);

}  // namespace plico
