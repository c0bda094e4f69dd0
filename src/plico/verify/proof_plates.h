// What the proof of a motion compares: shrunk convex plates, and which pairs of them can collide at all.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

struct ProofPlates {
  int num_panels = 0;
  // Of each plate in the flat state, counter-clockwise, convex; of a thick one those of the back, then of the front.
  std::vector<std::vector<Vec3>> corners;
  bool are_thick = false;
  std::vector<int> panel, part;          // of each plate
  std::vector<std::vector<int>> hinged;  // of each panel: those that a hinge keeps apart from it

  bool may_collide(int plate_a, int plate_b) const;
};

// Every side moves inward by `clearance`, less in panels too narrow for it and at tips, where no
// corner moves by more than four clearances; panels that are not convex become
// triangles. A hinge keeps its panels apart when they are thin and each lies on its own side of the hinge's line.
// O(corners^2) in the worst case.
ProofPlates proof_plates(const Linkage& linkage, double clearance);

}  // namespace plico
