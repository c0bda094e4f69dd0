#include "plico/unfold/heuristics.h"

#include <algorithm>
#include <numeric>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

Vec3 edge_direction(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return (mesh.point(mesh.to(h)) - mesh.point(mesh.from(h))).normalized();
}

// From the middle of one face to the middle of the other.
Vec3 dual_direction(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  if (mesh.is_boundary(e)) return Vec3::Zero();
  return (center(mesh, mesh.face(mesh.twin(h))) - center(mesh, mesh.face(h))).normalized();
}

double weight(const Mesh& mesh, EdgeId e, Heuristic heuristic, const Vec3& direction, double longest, Rng& rng) {
  switch (heuristic) {
    case Heuristic::SteepestEdge:
      return std::abs(direction.dot(edge_direction(mesh, e)));
    case Heuristic::UnsteepestEdge:
      return 1 - std::abs(direction.dot(edge_direction(mesh, e)));
    case Heuristic::FlatTree:
      return std::abs(direction.dot(dual_direction(mesh, e)));
    case Heuristic::SteepTree:
      return 1 - std::abs(direction.dot(dual_direction(mesh, e)));
    case Heuristic::MinimumPerimeter:
      return 1 - length(mesh, e) / longest;
    case Heuristic::MaximumPerimeter:
      return length(mesh, e) / longest;
    case Heuristic::Random:
      return rng.uniform();
  }
  return 0;
}

// Union-find with path halving.
class Sets {
 public:
  explicit Sets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  int find(int a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<int> parent_;
};

}  // namespace

std::string_view name(Heuristic heuristic) {
  switch (heuristic) {
    case Heuristic::SteepestEdge:
      return "steepest-edge";
    case Heuristic::FlatTree:
      return "flat-tree";
    case Heuristic::MinimumPerimeter:
      return "minimum-perimeter";
    case Heuristic::UnsteepestEdge:
      return "unsteepest-edge";
    case Heuristic::SteepTree:
      return "steep-tree";
    case Heuristic::MaximumPerimeter:
      return "maximum-perimeter";
    case Heuristic::Random:
      return "random";
  }
  return "unknown";
}

std::vector<double> dual_weights(const Mesh& mesh, Heuristic heuristic, const Vec3& direction, Rng& rng) {
  double longest = 0;
  for (EdgeId e : mesh.edges()) longest = std::max(longest, length(mesh, e));
  std::vector<double> weights;
  weights.reserve(mesh.num_edges());
  for (EdgeId e : mesh.edges()) weights.push_back(weight(mesh, e, heuristic, direction, longest, rng));
  return weights;
}

FoldForest lightest_forest(const Mesh& mesh, const std::vector<double>& weights) {
  std::vector<int> order;
  for (EdgeId e : mesh.edges())
    if (!mesh.is_boundary(e)) order.push_back(e);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return weights[a] != weights[b] ? weights[a] < weights[b] : a < b; });
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  Sets sets(mesh.num_faces());
  for (int e : order) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    forest.is_fold[e] = sets.join(mesh.face(h), mesh.face(mesh.twin(h)));
  }
  return forest;
}

Vec3 random_direction(Rng& rng) {
  for (;;) {
    // One draw a statement: in one list, compilers would choose the order. This one is what g++ chose.
    Vec3 v;
    v.z() = rng.normal();
    v.y() = rng.normal();
    v.x() = rng.normal();
    if (v.norm() > 1e-6) return v.normalized();
  }
}

}  // namespace plico
