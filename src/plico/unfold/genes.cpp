#include "plico/unfold/genes.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/unfold/overlap.h"

namespace plico {
namespace {
// A fan this much wider than 2 pi still only touches itself: rounding of flat vertices. Radians.
constexpr double kAngleRounding = 1e-9;
}  // namespace

FaultCounter::FaultCounter(const FlatFaces& faces) : faces_(&faces), first_spoke_{0} {
  const Mesh& mesh = faces.mesh();
  for (VertexId v : mesh.vertices()) {
    if (!mesh.halfedge(v).valid() || angle_sum(mesh, v) <= 2 * kPi + kAngleRounding) continue;
    HalfedgeId h = mesh.halfedge(v);
    do {
      spoke_.push_back({mesh.edge(h), corner_angle(mesh, h)});
      h = mesh.twin(mesh.prev(h));
    } while (h.valid() && h != mesh.halfedge(v));
    first_spoke_.push_back(static_cast<int>(spoke_.size()));
  }
}

Faults FaultCounter::operator()(const FoldForest& tree) const {
  return {static_cast<int>(overlapping_pairs(*faces_, lay_panels(*faces_, tree)).size()), local_overlaps(tree)};
}

int FaultCounter::local_overlaps(const FoldForest& tree) const {
  int count = 0;
  for (int i = 0; i + 1 < static_cast<int>(first_spoke_.size()); ++i) count += has_wide_fan(i, tree) ? 1 : 0;
  return count;
}

// Goes round once, starting at a cut; a spanning tree leaves one at every vertex.
bool FaultCounter::has_wide_fan(int vertex, const FoldForest& tree) const {
  const int first = first_spoke_[vertex], n = first_spoke_[vertex + 1] - first;
  int start = 0;
  while (start < n && tree.is_fold[spoke_[first + start].edge]) ++start;
  PLICO_ASSERT(start < n);
  double fan = 0;
  for (int i = 0; i < n; ++i) {
    const Spoke& spoke = spoke_[first + (start + i) % n];
    if (!tree.is_fold[spoke.edge]) fan = 0;
    fan += spoke.angle;
    if (fan > 2 * kPi + kAngleRounding) return true;
  }
  return false;
}

int tournament(const std::vector<double>& fitness, int size, Rng& rng) {
  const int n = static_cast<int>(fitness.size());
  int best = rng.below(n);
  for (int i = 1; i < size; ++i) {
    const int other = rng.below(n);
    if (fitness[other] > fitness[best]) best = other;
  }
  return best;
}

Genes uniform_crossover(const Genes& mother, const Genes& father, Rng& rng) {
  Genes child(mother);
  for (std::size_t i = 0; i < child.size(); ++i)
    if (rng.uniform() < 0.5) child[i] = father[i];
  return child;
}

void mutate(Genes& genes, double probability, double variance, Rng& rng) {
  const double deviation = std::sqrt(variance);
  for (double& gene : genes)
    if (rng.uniform() < probability) gene = std::clamp(gene + deviation * rng.normal(), 0.0, 1.0);
}

}  // namespace plico
