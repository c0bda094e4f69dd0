// A walk through all squares that rises: it visits them roughly in the order of their height along an axis. A chain
// that runs so is built from the ground up when it unrolls: what stands lies below what is to come, and the rest of the
// pile has all the room above. Ours; a chain cut from any cycle of some thousand squares gets stuck in its own shape.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "plico/base/run.h"
#include "plico/stack/path_exchange.h"
#include "plico/stack/voxel_shell.h"

namespace plico {

enum class Upwards : std::uint8_t { PlusX, PlusY, PlusZ, MinusX, MinusY, MinusZ };

// All six, the one first in which most squares are low: narrow parts then come last, when the pile is short.
std::array<Upwards, 6> directions_to_rise(const VoxelShell& shell);

struct RisingOptions {
  std::uint64_t seed = 1;
  Upwards upwards = Upwards::PlusZ;
  long exchanges = 0;  // tried; 0: 1000 a square, at most 20 million
};

// How far a walk is from rising: places by which a square is too early or too late, on average. 0: heights never fall.
double places_astray(const VoxelShell& shell, const std::vector<int>& path, Upwards upwards);

// From the lowest square on, by exchanges (path_exchange.h) that are annealed: what makes it worse is taken, too, ever
// less often. `cycle` visits every square once; where it closes it is cut before its lowest square, otherwise its first
// square stays the first. O(exchanges * squares that one moves). A run that is over leaves the best it has: a walk.
std::vector<int> rising_path(const VoxelShell& shell, const SquareGraph& graph, std::vector<int> cycle,
                             const RisingOptions& options = {}, const Run& run = {});

}  // namespace plico
