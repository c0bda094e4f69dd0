#include "plico/workflow/voxel_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

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

// Sides of polygons without another polygon beside them.
long open_sides(const PolygonSoup& soup) {
  std::vector<std::pair<int, int>> sides;
  for (int f = 0; f < soup.num_faces(); ++f) {
    const std::span<const int> face = soup.face(f);
    for (std::size_t i = 0; i < face.size(); ++i)
      sides.emplace_back(std::minmax({face[i], face[(i + 1) % face.size()]}));
  }
  std::sort(sides.begin(), sides.end());
  long open = 0;
  for (std::size_t i = 0; i < sides.size();) {
    const auto end = std::upper_bound(sides.begin() + static_cast<std::ptrdiff_t>(i), sides.end(), sides[i]);
    open += end - sides.begin() - static_cast<std::ptrdiff_t>(i) == 1;
    i = static_cast<std::size_t>(end - sides.begin());
  }
  return open;
}

void note_holes(long open, VoxelPieces& all) {
  const long enclosed = all.solid.filled - all.solid.touched;
  if (open > 0 && enclosed > 0)
    all.notes.push_back(
        fmt::format("the mesh has {} open edges; holes smaller than a voxel are closed, and {} voxels are enclosed",
                    open, enclosed));
  else if (open > 0)
    all.notes.push_back(fmt::format(
        "the mesh has {} open edges; what is behind holes larger than a voxel is outside, and no voxel is enclosed",
        open));
  else if (enclosed == 0)
    all.notes.push_back(
        "no voxel is wholly inside of the mesh: it is hardly thicker than a voxel, and detail is lost; try more "
        "--cells");
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

void refine_voxels(Voxelization& solid, int factor) {
  if (factor == 1) return;
  solid.grid = refined(solid.grid, factor);
  const long each = static_cast<long>(factor) * factor * factor;
  solid.side /= factor;
  solid.touched *= each;
  solid.filled *= each;
}

VoxelPieces voxel_pieces(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing) {
  VoxelPieces all;
  all.pairing = pairing;
  all.solid = voxelize(soup, cells_of(soup, resolution));
  refine_voxels(all.solid, resolution.refine);
  all.pieces = pieces_of(shell_of(all.solid.grid, pairing));
  note_holes(open_sides(soup), all);
  return all;
}

VoxelMesh piece_of(const VoxelPieces& all, std::size_t which) {
  VoxelMesh piece{all.solid, {}, all.pairing, {}, all.notes};
  piece.solid.grid = behind(all.solid.grid, all.pieces[which]);
  piece.shell = shell_of(piece.solid.grid, all.pairing);
  return piece;
}

VoxelMesh largest_piece(VoxelPieces all) {
  if (all.pieces.size() == 1)
    return {std::move(all.solid), std::move(all.pieces[0]), all.pairing, {}, std::move(all.notes)};
  VoxelMesh largest = piece_of(all, 0);
  for (std::size_t i = 1; i < all.pieces.size(); ++i) largest.other_pieces.push_back(all.pieces[i].size());
  largest.notes.insert(largest.notes.begin(),
                       fmt::format("the voxels make {} pieces; the largest is taken, of {} squares", all.pieces.size(),
                                   all.pieces[0].size()));
  return largest;
}

VoxelMesh voxel_mesh(const PolygonSoup& soup, const Resolution& resolution, Pairing pairing) {
  return largest_piece(voxel_pieces(soup, resolution, pairing));
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
