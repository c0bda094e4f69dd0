// From voxels to a chain of thick squares in its most compact stack, judged, and as files. Source: [Xi17] chapter 6.
#pragma once
#include <optional>
#include <string>

#include "plico/io/mesh/threemf.h"
#include "plico/io/pattern/fold.h"
#include "plico/stack/compact.h"
#include "plico/verify/chain.h"
#include "plico/workflow/voxel_mesh.h"

namespace plico {

struct StackMeshOptions {
  std::uint64_t seed = 1;
  double thickness = 0.1;                       // of the panels, in voxel sides, in (0, 0.5)
  double trim = 0;                              // of every panel side, in [thickness / 2, thickness]; 0: the thickness
  int width = 0, depth = 0;                     // of the base in panels; 0: the base with the least W + D + H
  long exchanges = CompactOptions().exchanges;  // of squares, tried where cuts alone are not enough
  int reach = CompactOptions().reach;           // places by which one of them moves a square, at most
  bool as_it_runs = false;                      // a walk that closes is not cut elsewhere
};

struct StackedChain {
  CompactResult found;
  ChainClaim claim;                                               // in the mesh's unit
  ChainVerdict verdict;                                           // on the claim
  double compactness = 0, volume_ratio = 0, slots_per_panel = 0;  // R14, held against the voxels
};

// Throws InvalidOption unless thickness and trim are in their ranges.
void check(const StackMeshOptions& options);

// `cycle` visits every square of the shell once; it need not close. Throws InvalidOption.
StackedChain stack_voxels(const VoxelMesh& voxels, const std::vector<int>& cycle, const StackMeshOptions& options,
                          const Run& run = {});

// The same for a stack that is there already, of the chain in its path.
StackedChain stacked_chain(const VoxelMesh& voxels, CompactResult found, const StackMeshOptions& options);

// The claim as a FOLD file: the strip as key frame, the shape as folded form, the rest under plico:chain; and back.
// chain_claim() is empty for a file of another kind and throws InvalidInput ("chain/file") for a broken one.
FoldFile chain_file(const ChainClaim& claim);
std::optional<ChainClaim> chain_claim(const FoldFile& file);

// One row a panel: where its square is in the shape and where it lies in the stack.
std::string chain_table(const VoxelMesh& voxels, const Stack& stack, const ChainClaim& claim);

// What is printed of a chain: its panels as they lie in the stack or stand in the shape, 2 % thinner than they are so
// that they do not touch, or one panel.
enum class ChainSolid { Stack, Panel, Shape };

// Its lengths are such that squares have sides of `side`; the least coordinates are 0.
PlacedSolid chain_solid(const ChainClaim& claim, ChainSolid what, double side);

}  // namespace plico
