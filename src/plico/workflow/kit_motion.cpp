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

// The hinge of a part, in the order of its own net, for every hinge of the whole net; -1 for those of other parts.
std::vector<int> hinges_of_part(const ProvenPart& part, const std::vector<int>& whole, int num_hinges) {
  std::vector<int> result(num_hinges, -1);
  const std::vector<int> hinge = hinge_of_edge(part.net.sheet);
  for (std::size_t e = 0; e < hinge.size(); ++e)
    if (hinge[e] >= 0) result[whole[part.shape.edge[part.net.mesh_edge[e]]]] = hinge[e];
  return result;
}

FoldingPath share_of_piece(const NetPiece& piece, const std::vector<int>& hinges, const FoldingPath& of_part) {
  FoldingPath path;
  for (const Waypoint& waypoint : of_part.waypoints) {
    Configuration config(static_cast<Eigen::Index>(piece.hinge.size()));
    for (std::size_t h = 0; h < piece.hinge.size(); ++h)
      config[static_cast<Eigen::Index>(h)] = waypoint.config[hinges[piece.hinge[h]]];
    path.waypoints.push_back({waypoint.time, std::move(config)});
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

std::vector<std::optional<FoldingPath>> paths_of_pieces(const Mesh& mesh, const Kit& kit,
                                                        const std::vector<NetPiece>& pieces) {
  const std::vector<int> whole = hinge_of_mesh_edge(mesh, kit.net);
  int num_hinges = 0;
  for (const NetPiece& piece : pieces) num_hinges += static_cast<int>(piece.hinge.size());
  std::vector<std::optional<FoldingPath>> paths(pieces.size());
  for (std::size_t i = 0; i < kit.part.size(); ++i) {
    if (!kit.part[i].motion) continue;
    const std::vector<int> hinges = hinges_of_part(kit.part[i], whole, num_hinges);
    for (int p : kit.pieces[i])
      if (!pieces[p].hinge.empty()) paths[p] = share_of_piece(pieces[p], hinges, kit.part[i].motion->path);
  }
  return paths;
}

std::optional<Motion> motion_of_pieces(const Mesh& mesh, const Kit& kit, const Run& run) {
  const Linkage linkage = linkage_of(kit.net);
  if (linkage.num_hinges() == 0) return std::nullopt;
  const std::vector<NetPiece> pieces = pieces_of(kit.net);
  FoldingPath path = joined_path(linkage, pieces, paths_of_pieces(mesh, kit, pieces));
  const PathProof proof = prove_path(linkage, path, {.clearance = clearance_for_all(kit)}, run);
  return Motion{method_of(kit), std::move(path), proof};
}

}  // namespace plico
