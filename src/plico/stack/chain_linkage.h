// The chain as a linkage: thick square panels in a row, joined at thick hinges (R11). It lies flat as the strip runs,
// over itself where it must: it almost never has a flat state without overlap, and is never asked for one.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/stack/lattice.h"

namespace plico {

struct ChainShape {
  double side = 1;       // of a voxel
  double thickness = 0;  // of the panels, below side / 2
  double trim = 0;       // of every panel side, at least thickness / 2 (where the axes lie), below side / 2
};

// Panel 0 is the root, with its centre at the origin; hinge i leads from panel i to panel i + 1, East is +x. `angles`
// are the goal, one a hinge, radians. Throws InvalidOption when thickness or trim is out of range.
Linkage chain_linkage(const Headings& headings, const std::vector<double>& angles, const ChainShape& shape);

}  // namespace plico
