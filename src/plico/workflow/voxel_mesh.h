// From a mesh to its voxel shell with a proven cycle through all squares.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/soup.h"
#include "plico/stack/hamiltonian_cycle.h"
#include "plico/stack/path_exchange.h"
#include "plico/stack/voxelize.h"
#include "plico/verify/shell_cycle.h"

namespace plico {

// How fine: exactly one of the first three is above 0.
struct Resolution {
  double cells = 0;  // voxels along the longest side
  double size = 0;   // side of a voxel, the mesh's unit
  int squares = 0;   // of the shell, or as near as it gets
  int refine = 1;    // then every voxel is cut into refine x refine x refine; with 2 a cycle is certain
};

// The voxels of a surface, and their boundary piece by piece, the largest first.
struct VoxelPieces {
  Voxelization solid;
  std::vector<VoxelShell> pieces;  // at least one
  Pairing pairing = Pairing::Solid;
  std::vector<std::string> notes;  // what the voxels changed about the shape; sentences
};

struct VoxelMesh {
  Voxelization solid;  // without what the pieces left out enclose
  VoxelShell shell;    // the largest piece
  Pairing pairing = Pairing::Solid;
  std::vector<int> other_pieces;   // squares of the pieces that are left out
  std::vector<std::string> notes;  // what the voxels changed about the shape; sentences
};

// The voxels that the surface touches and encloses. Throws as voxelize(), and InvalidOption unless one resolution is
// given.
VoxelPieces voxel_pieces(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing = Pairing::Solid);

// Every voxel cut into factor x factor x factor. Throws InvalidOption as refined() does.
void refine_voxels(Voxelization& solid, int factor);

// One piece by itself; it says nothing of the others. O(voxels).
VoxelMesh piece_of(const VoxelPieces& all, std::size_t which);

// The largest piece, and how many squares the others have. O(voxels).
VoxelMesh largest_piece(VoxelPieces all);
VoxelMesh voxel_mesh(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing = Pairing::Solid);

// The search for a cycle, and what the judge says about it (no problem, and not judged, when none was found). Of at
// most kMostDecided squares it is decided whether there is one, and a path is found where there is none.
struct JudgedCycle {
  static constexpr int kMostDecided = 200;

  CycleResult found;
  CycleVerdict verdict;      // on the cycle, or on the path
  bool proven_none = false;  // there is no cycle
  std::vector<int> path;     // then a walk through every square that does not close; empty: there is none either

  const std::vector<int>& walk() const { return found.cycle.empty() ? path : found.cycle; }
};
JudgedCycle judged_cycle(const VoxelMesh& voxels, const CycleOptions& options, const Run& run = {});

// Why there is no cycle, and what to do about it: a sentence.
std::string no_cycle_text(const VoxelMesh& voxels, const JudgedCycle& cycle);

SquareGraph graph_of(const VoxelShell& shell);

}  // namespace plico
