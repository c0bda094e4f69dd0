#include "plico/segment/dual_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plico/base/libm.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kFineMesh = 2000;  // faces: from here on a valley is spread over several edges

// Chosen on animals whose limbs are known (bench/segment, seeds 11-15) and on the meshes of its tables.
constexpr double kSlopeWeight = 0.25;
constexpr double kLeastShare = 0.3;        // of the cost, however steeply the thickness changes
constexpr double kEvenThickness = 8 / 7.;  // where it does not change: costs stay the same on the whole

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
      arcs_.push_back({other, length(mesh, e) * seam_factor(sharper * fold_angle(mesh, e)), length(mesh, e),
                       (center(mesh, f) - middle).norm() + (center(mesh, other) - middle).norm()});
    }
    first_.push_back(static_cast<int>(arcs_.size()));
  }
}

double DualGraph::held_cost() const { return 100 * std::sqrt(total_area_); }

void DualGraph::hold(int a, int b) {
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
    for (int i = first_[from]; i < first_[from + 1]; ++i)
      if (arcs_[i].to == to) arcs_[i].cost = held_cost();
}

void DualGraph::discount(const std::vector<double>& thick) {
  for (int f = 0; f < num_faces(); ++f)
    for (int i = first_[f]; i < first_[f + 1]; ++i) {
      Arc& arc = arcs_[i];
      const double a = thick[f], b = thick[arc.to];
      if (!(a > 0 && b > 0 && arc.distance > 0) || arc.cost >= held_cost()) continue;
      const double slope = std::abs(a - b) / arc.distance;
      arc.cost *= kEvenThickness * std::max(kLeastShare, plico::pow(std::numbers::e, -kSlopeWeight * slope));
    }
}

DualGraph DualGraph::with_length(double share) const {
  DualGraph longer = *this;
  for (Arc& arc : longer.arcs_) arc.cost += share * arc.length;
  return longer;
}

double seam_factor(double fold_angle) {
  constexpr double kFall = 0.45;  // radians
  if (fold_angle > 0) return std::max(0.12, plico::pow(std::numbers::e, -fold_angle / kFall));
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
