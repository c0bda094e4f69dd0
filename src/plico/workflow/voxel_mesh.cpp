#include "plico/workflow/voxel_mesh.h"

#include <fmt/format.h>

#include "plico/base/error.h"

namespace plico {
namespace {

double cells_of(const PolygonSoup& soup, const Resolution& resolution) {
  if ((resolution.cells != 0) + (resolution.size != 0) + (resolution.squares != 0) != 1)
    throw InvalidOption("exactly one of cells, size and squares must be given", "--cells 25");
  if (resolution.squares != 0) return cells_for_squares(soup, resolution.squares);
  if (resolution.cells != 0) return resolution.cells;
  require(resolution.size > 0, "size", resolution.size, "above 0");
  Eigen::AlignedBox3d box;
  for (int v : soup.corners) box.extend(soup.points[v]);
  return std::max(1.0, box.sizes().maxCoeff() / resolution.size);
}

// The voxels behind the squares of one piece, and all that they enclose.
VoxelGrid behind(const VoxelGrid& all, const VoxelShell& piece) {
  VoxelGrid grid(all.nx(), all.ny(), all.nz());
  for (const ShellSquare& square : piece.squares) grid.fill(square.voxel);
  grid.fill_enclosed();
  return grid;
}

}  // namespace

VoxelMesh voxel_mesh(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing) {
  VoxelMesh result;
  result.pairing = pairing;
  result.solid = voxelize(soup, cells_of(soup, resolution));
  const std::vector<VoxelShell> pieces = pieces_of(shell_of(result.solid.grid, pairing));
  for (std::size_t i = 1; i < pieces.size(); ++i) result.other_pieces.push_back(pieces[i].size());
  if (pieces.size() > 1) {
    result.solid.grid = behind(result.solid.grid, pieces.front());
    result.shell = shell_of(result.solid.grid, pairing);
    result.notes.push_back(
        fmt::format("the voxels make {} pieces; the largest is taken, of {} squares", pieces.size(), pieces[0].size()));
  } else {
    result.shell = pieces.front();
  }
  if (result.solid.filled == result.solid.touched)
    result.notes.push_back("the surface encloses no voxel: it is open, or as thin as a voxel");
  return result;
}

JudgedCycle judged_cycle(const VoxelMesh& voxels, const CycleOptions& options, const Run& run) {
  JudgedCycle result{find_hamiltonian_cycle(voxels.shell, options, run), {}};
  if (result.found.ending != Ending::Found) return result;
  std::vector<ShellSquare> walk;
  for (int s : result.found.cycle) walk.push_back(voxels.shell.squares[s]);
  result.verdict = verify_shell_cycle(voxels.solid.grid, voxels.pairing, walk);
  return result;
}

}  // namespace plico
