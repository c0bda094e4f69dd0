#include "plico/workflow/kit_motion.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

// The hinge of the whole net at every edge of the mesh, -1 for none.
std::vector<int> hinge_of_mesh_edge(const Mesh& mesh, const Unfolding& net) {
  const std::vector<int> hinge = hinge_of_edge(net.sheet);
  std::vector<int> of_edge(mesh.num_edges(), -1);
  for (std::size_t e = 0; e < hinge.size(); ++e)
    if (hinge[e] >= 0) of_edge[net.mesh_edge[e]] = hinge[e];
  return of_edge;
}

// The hinge of the whole net for every hinge of one piece.
std::vector<int> hinges_of_piece(const ProvenPart& piece, const std::vector<int>& whole) {
  std::vector<int> result;
  const std::vector<int> hinge = hinge_of_edge(piece.net.sheet);
  for (std::size_t e = 0; e < hinge.size(); ++e)
    if (hinge[e] >= 0) result.push_back(whole[piece.shape.edge[piece.net.mesh_edge[e]]]);
  return result;
}

std::vector<double> times_of(const Kit& kit) {
  std::vector<double> times{0, 1};
  for (const ProvenPart& piece : kit.part)
    if (piece.motion)
      for (const Waypoint& waypoint : piece.motion->path.waypoints) times.push_back(waypoint.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

FoldingPath joined_path(const Mesh& mesh, const Kit& kit, const Linkage& linkage) {
  const std::vector<int> whole = hinge_of_mesh_edge(mesh, kit.net);
  FoldingPath path;
  for (double time : times_of(kit)) path.waypoints.push_back({time, time * goal(linkage)});
  for (const ProvenPart& piece : kit.part) {
    if (!piece.motion) continue;
    const std::vector<int> hinges = hinges_of_piece(piece, whole);
    for (Waypoint& waypoint : path.waypoints) {
      const Configuration config = piece.motion->path.at(waypoint.time);
      for (std::size_t h = 0; h < hinges.size(); ++h) waypoint.config[hinges[h]] = config[static_cast<int>(h)];
    }
  }
  return path;
}

MotionMethod method_of(const Kit& kit) {
  std::optional<MotionMethod> common;
  for (const ProvenPart& piece : kit.part) {
    if (!piece.motion) continue;
    if (common && *common != piece.motion->method) return MotionMethod::LazyPrm;
    common = piece.motion->method;
  }
  return common.value_or(MotionMethod::Linear);
}

// Every piece is proven by itself, with a clearance that suits its panels; the largest of these suits all. 0 for none.
double clearance_for_all(const Kit& kit) {
  double largest = 0;
  for (const ProvenPart& piece : kit.part)
    if (piece.motion) largest = std::max(largest, piece.motion->proof.clearance);
  return largest;
}

}  // namespace

std::optional<Motion> motion_of_pieces(const Mesh& mesh, const Kit& kit, const Run& run) {
  const Linkage linkage = linkage_of(kit.net);
  if (linkage.num_hinges() == 0) return std::nullopt;
  FoldingPath path = joined_path(mesh, kit, linkage);
  const PathProof proof = prove_path(linkage, path, {.clearance = clearance_for_all(kit)}, run);
  return Motion{method_of(kit), std::move(path), proof};
}

}  // namespace plico
