// The motion of a stacked chain, from the stack through one pile to the shape: planned, and judged by
// verify/chain_motion. Stack and motion are searched jointly: a chain that does not peel gives way to one
// that rises, stacked anew.
#pragma once
#include "plico/io/pattern/fold.h"
#include "plico/stack/unpack.h"
#include "plico/verify/chain_motion.h"
#include "plico/workflow/stack_mesh.h"

namespace plico {

struct StackMotionOptions {
  std::uint64_t seed = 1;
  bool to_shape = true;  // else only to the pile
  // Chains tried: the given one from both ends and upside down, unless it is long, then such as rise (rising_path.h).
  // 0: as many as 20,000 panels make, 6 to 40, because long ones take long.
  int chains = 0;
  PeelOptions peel = {};
};

struct StackMotion {
  Ending ending = Ending::Exhausted;  // Found: all the way, and free
  StackedChain chain;                 // the one that moves; others than the first may need more layers
  FoldingPath path;                   // from its stack as far as it goes
  ChainMotionVerdict verdict;
  int chains = 0;        // tried
  double share() const;  // of its hinges that reach the shape
};

// `first` is a stack of `voxels` as stack_voxels() makes it. There always is a result: the stack swung into one pile,
// with the longest prefix of the shape that was found. Throws InvalidOption.
StackMotion unpack_stack(const VoxelMesh& voxels, const StackedChain& first, const StackMeshOptions& stacking,
                         const StackMotionOptions& options = {}, const Run& run = {});

// The chain with its motion; one that ends short of the shape says so. Motions of at most kMostFramedPanels panels
// times waypoints are frames. Longer ones, which would be hundreds of megabytes, are told by what turns from one
// waypoint to the next, under plico:chain.
constexpr long kMostFramedPanels = 200'000;
FoldFile chain_motion_file(const StackMotion& motion);

// Gives a file read from there its motion (FoldFile::path) when it is told by what turns; otherwise does nothing.
// Throws InvalidInput ("chain/motion").
void take_told_motion(FoldFile& file, const ChainClaim& claim);

}  // namespace plico
