// Numbers for the edges that are glued between two parts.
#pragma once
#include <vector>

#include "plico/mesh/segmentation.h"

namespace plico {

// The number of every mesh edge, 0 when it is no seam. Numbers 1, 2 ... run along each seam: from part to part in
// ascending order, and between two parts from one end of a chain of edges to the other. O(seams log seams).
std::vector<int> seam_numbers(const Mesh& mesh, const Segmentation& segmentation);

// Who is glued to whom, and how much of it.
struct SeamLength {
  int a = 0, b = 0;   // parts, a < b
  double length = 0;  // units
};
std::vector<SeamLength> seam_lengths(const Mesh& mesh, const Segmentation& segmentation);  // by a, then b

}  // namespace plico
