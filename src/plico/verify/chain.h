// Judges a chain of thick squares from scratch: does it fold into the shape, is every square of it there once, and do
// its panels lie in slots of their own in the stack? Knows nothing of the searches; positions come from the thick
// folding map alone (R11). Source: [Xi17] 6.3.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/verify/net.h"

namespace plico {

struct ChainClaim {
  CreasePattern sheet;                   // the strip laid flat: panel after panel; fold angles are those of the shape
  std::vector<Vec3> shape;               // its vertices in the shape
  double thickness = 0;                  // of the panels, in units of the sheet
  double trim = 0;                       // of every panel side
  std::vector<double> stack;             // fold angle of every hinge in the stack, radians
  int width = 0, depth = 0, height = 0;  // the box of the stack in panels, as claimed
  int opened = -1;  // hinges, from the first on, that a motion says it brings into the shape; -1: all
};

struct ChainVerdict {
  int panels = 0;
  double side = 0;                       // of the squares
  int width = 0, depth = 0, height = 0;  // of the stack, as found; base either way round
  int ideal = 0;                         // fewest layers on this base
  double shape_error = 0;                // worst distance of a folded corner from the shape's, in sides
  double stack_error = 0;                // worst distance of a panel from its slot, in sides
  double size_sum = 0;                   // W + D + H of the stack, in sides (R14)
  double volume = 0;                     // of its box, in cubes of a side (R14)
  std::vector<Defect> defects;           // empty when the claim holds; of one kind the first

  bool valid() const { return defects.empty(); }
};

// Checks that
// (within 1e-9 sides; beyond 10,000 panels 1e-13 a panel, the rounding of so many poses in a row)
//   - panels are equal squares, hinge i joins panels i and i + 1, and there is no other hinge;
//   - folding by the shape's angles puts every corner where the shape has it;
//   - the shape's squares lie in one cubic lattice, no square twice, and its sides meet in pairs: it is closed;
//   - folding by the stack's angles puts every panel into a slot (x, y, layer) of its own, the box as claimed.
// Never throws for a wrong chain: it says what is wrong. O(n log n).
ChainVerdict verify_chain(const ChainClaim& claim);

// The rigid motion that takes the first panel from the sheet to the shape. The claim must have a panel.
Pose into_shape(const ChainClaim& claim);

// The linkage that the claim speaks of: panel 0 at rest, thick hinges. Throws InvalidOption or InvalidInput.
Linkage chain_linkage_of(const ChainClaim& claim);

}  // namespace plico
