#include "plico/segment/dual_graph.h"

#include <algorithm>
#include <cmath>

#include "plico/base/libm.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kFineMesh = 2000;  // faces: from here on a valley is spread over several edges

}  // namespace

DualGraph::DualGraph(const Mesh& mesh) {
  const double sharper = std::sqrt(std::max(1.0, static_cast<double>(mesh.num_faces()) / kFineMesh));
  for (FaceId f : mesh.faces()) {
    area_.push_back(plico::area(mesh, f));
    total_area_ += area_.back();
    for (HalfedgeId h : mesh.halfedges(f)) {
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.valid()) continue;
      const FaceId other = mesh.face(twin);
      const Vec3 middle = (mesh.point(mesh.from(h)) + mesh.point(mesh.to(h))) / 2;
      const EdgeId e = mesh.edge(h);
      arcs_.push_back({other, length(mesh, e) * seam_factor(sharper * fold_angle(mesh, e)),
                       (center(mesh, f) - middle).norm() + (center(mesh, other) - middle).norm()});
    }
    first_.push_back(static_cast<int>(arcs_.size()));
  }
}

double seam_factor(double fold_angle) {
  constexpr double kFall = 0.45;  // radians
  constexpr double kEuler = 2.71828182845904523536;
  if (fold_angle > 0) return std::max(0.12, plico::pow(kEuler, -fold_angle / kFall));
  return 1 - 0.25 * std::min(1.0, -fold_angle / (kPi / 2));
}

double cut_cost(const DualGraph& graph, std::span<const int> side_faces, const std::vector<int>& mark, int rest) {
  double cost = 0;
  for (int f : side_faces)
    for (const DualGraph::Arc& arc : graph.arcs(f))
      if (mark[arc.to] == rest) cost += arc.cost;
  return cost;
}

}  // namespace plico
