// A closed walk over the squares of a voxel shell that visits each exactly once. Source: [Xi17] 6.3.2, which asks a
// solver for travelling salesmen; this search knows that the graph is the dual of a surface of squares.
#pragma once
#include <cstdint>
#include <vector>

#include "plico/base/run.h"
#include "plico/stack/voxel_shell.h"

namespace plico {

struct CycleOptions {
  std::uint64_t seed = 1;
  long max_tries = 200'000'000;  // walks tried, see below; a count, so that the same seed gives the same cycle
};

struct CycleResult {
  Ending ending = Ending::Exhausted;  // Found: one cycle
  std::vector<int> cycle;             // squares in order, each adjacent to the next and the last to the first
  int rings = 0;                      // short cycles to begin with
  int left = 0;                       // cycles in the end; 1 when found
  long tries = 0;
};

// Rings of squares around every second vertex make cycles that cover everything; cycles side by side are merged, the
// rest by exchanges along closed walks that take away and add a link in turn, up to eight of each, and never make more
// cycles. Not every shell has such a cycle, and none may be found where there is one (R12). About n log n in practice.
// Throws InvalidInput when the shell is empty or in several pieces.
CycleResult find_hamiltonian_cycle(const VoxelShell& shell, const CycleOptions& options = {}, const Run& run = {});

}  // namespace plico
