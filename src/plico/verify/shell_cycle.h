// Judges a closed walk over the boundary squares of a solid made of voxels: whether it visits each exactly once, over
// edges that the shell really has. Knows the voxels only; the boundary is found anew.
#pragma once
#include <string>
#include <vector>

#include "plico/stack/voxel_shell.h"

namespace plico {

struct CycleVerdict {
  int squares = 0;                    // of the boundary of the solid voxels
  std::vector<std::string> problems;  // one sentence each; empty when the walk is a Hamiltonian cycle

  bool valid() const { return problems.empty(); }
};

// `cycle` lists squares by voxel and normal. Where four squares meet in an edge, only those that `pairing` joins are
// neighbours. A boundary in several pieces has no such cycle. At most ten problems are told. O(n log n).
CycleVerdict verify_shell_cycle(const VoxelGrid& grid, Pairing pairing, const std::vector<ShellSquare>& cycle);

// The same for a walk that need not close.
CycleVerdict verify_shell_path(const VoxelGrid& grid, Pairing pairing, const std::vector<ShellSquare>& path);

}  // namespace plico
