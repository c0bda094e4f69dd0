// The panels of a linkage as convex plates, thin or as thick as the linkage says, shrunk toward their interior, the way
// collision checks see them.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

// Plates of one panel are numbered consecutively; a convex panel is one plate, any other is cut into triangles.
struct Plates {
  // Flat state, one plate after the other, counter-clockwise; of thick plates the corners of the back (z < 0), then
  // those of the front in the same order.
  std::vector<Vec3> corners;
  std::vector<int> first = {0};           // plates + 1: plate i has corners [first[i], first[i + 1])
  std::vector<int> panel;                 // of each plate
  std::vector<int> first_of_panel = {0};  // panels + 1
  bool are_thick = false;

  int num_sides(int plate) const { return (first[plate + 1] - first[plate]) / (are_thick ? 2 : 1); }
  int size() const { return static_cast<int>(panel.size()); }
};

// Every side moves inward by `clearance`, or by less where a panel is so narrow that a side would lose half its length.
// The thickness is not shrunk: plates that lie on each other touch. At tips sharper than 29 degrees the sides turn
// instead, so that no corner moves by more than four clearances. Throws InvalidOption when `clearance` is negative or
// not finite. O(corners), cubic in those of a non-convex panel.
Plates make_plates(const Linkage& linkage, double clearance);

}  // namespace plico
