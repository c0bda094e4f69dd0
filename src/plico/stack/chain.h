// A chain of squares: a Hamiltonian path of a voxel shell, told as what its hinges do.
#pragma once
#include <vector>

#include "plico/stack/lattice.h"
#include "plico/stack/voxel_shell.h"

namespace plico {

struct Chain {
  std::vector<int> squares;  // of the shell, in order
  Headings headings;         // of every hinge when the strip is laid flat, fronts up; the first is East
  std::vector<double>
      angles;  // of every hinge in the shape, radians: 0, pi/2 concave (valley), -pi/2 convex (mountain)
};

// The cycle cut open before its square `start` (an index into it), walked forwards or backwards. Every two squares in a
// row must be neighbours. O(n).
Chain chain_of(const VoxelShell& shell, const std::vector<int>& cycle, int start = 0, bool backwards = false);

}  // namespace plico
