#include "plico/workflow/voxel_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/base/error.h"
#include "plico/stack/decide_walk.h"

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

void refine(Voxelization& solid, int factor) {
  solid.grid = refined(solid.grid, factor);
  const long each = static_cast<long>(factor) * factor * factor;
  solid.side /= factor;
  solid.touched *= each;
  solid.filled *= each;
}

// Where the search gave up, an answer by SAT: a cycle, or the proof that there is none, and then a path.
void decide(const VoxelMesh& voxels, JudgedCycle& cycle, const Run& run) {
  const SquareGraph graph = graph_of(voxels.shell);
  WalkDecision decision = decide_walk(graph, Walk::Cycle, run);
  cycle.found.ending = decision.ending;
  cycle.found.cycle = std::move(decision.squares);
  if (decision.ending == Ending::Found) cycle.found.left = 1;
  if (decision.ending != Ending::Exhausted) return;
  cycle.proven_none = true;
  decision = decide_walk(graph, Walk::Path, run);
  cycle.path = std::move(decision.squares);
  if (decision.ending != Ending::Found) cycle.found.ending = decision.ending;
}

constexpr long kTriesBeforeDeciding = 200'000;

}  // namespace

VoxelMesh voxel_mesh(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing) {
  VoxelMesh result;
  result.pairing = pairing;
  result.solid = voxelize(soup, cells_of(soup, resolution));
  refine(result.solid, resolution.refine);
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
  const bool small = voxels.shell.size() <= JudgedCycle::kMostDecided;
  CycleOptions tries = options;
  if (small) tries.max_tries = std::min(tries.max_tries, kTriesBeforeDeciding);
  JudgedCycle result;
  result.found = find_hamiltonian_cycle(voxels.shell, tries, run);
  if (small && result.found.ending == Ending::Exhausted) decide(voxels, result, run);
  if (result.walk().empty()) return result;
  std::vector<ShellSquare> walk;
  for (int s : result.walk()) walk.push_back(voxels.shell.squares[s]);
  const auto verify = result.path.empty() ? verify_shell_cycle : verify_shell_path;
  result.verdict = verify(voxels.solid.grid, voxels.pairing, walk);
  return result;
}

std::string no_cycle_text(const VoxelMesh& voxels, const JudgedCycle& cycle) {
  if (!cycle.proven_none)
    return fmt::format("no cycle through all {} squares was found, {} cycles are left; with --refine 2 there is one",
                       voxels.shell.size(), cycle.found.left);
  if (cycle.path.empty() && cycle.found.ending != Ending::Exhausted)
    return fmt::format("no cycle visits each of the {} squares once, which is proven; no time was left for a path",
                       voxels.shell.size());
  if (cycle.path.empty())
    return fmt::format("no walk visits each of the {} squares once, which is proven; with --refine 2 there is one",
                       voxels.shell.size());
  return fmt::format("no cycle visits each of the {} squares once, which is proven; a path that does not close does",
                     voxels.shell.size());
}

SquareGraph graph_of(const VoxelShell& shell) {
  SquareGraph graph;
  for (const ShellSquare& square : shell.squares) graph.neighbours.push_back(square.neighbor);
  return graph;
}

}  // namespace plico
