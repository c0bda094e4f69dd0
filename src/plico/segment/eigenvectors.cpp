#include "plico/segment/eigenvectors.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "plico/base/rng.h"

namespace plico {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int kGuardVectors = 3;  // iterated along, so that those wanted converge
constexpr int kRounds = 12;
constexpr double kShift = 1e-3;  // of the mean diagonal, which makes the matrix definite
constexpr std::uint64_t kStartVectors = 40;

struct Operator {
  Sparse laplace;
  Eigen::VectorXd mass;
};

Operator laplace_of(const DualGraph& graph, const std::vector<int>& faces) {
  const int n = static_cast<int>(faces.size());
  std::vector<int> local(graph.num_faces(), -1);
  for (int i = 0; i < n; ++i) local[faces[i]] = i;
  std::vector<Eigen::Triplet<double>> entries;
  Operator op{Sparse(n, n), Eigen::VectorXd(n)};
  double total = 0;
  for (int i = 0; i < n; ++i) total += graph.area(faces[i]);
  for (int i = 0; i < n; ++i) {
    // Slivers weigh a little, or their values would be free.
    op.mass[i] = graph.area(faces[i]) / total + 1e-6 / n;
    double sum = 0;
    for (const DualGraph::Arc& arc : graph.arcs(faces[i])) {
      if (local[arc.to] < 0 || arc.distance <= 0) continue;
      const double weight = arc.cost / arc.distance;
      sum += weight;
      entries.emplace_back(i, local[arc.to], -weight);
    }
    entries.emplace_back(i, i, sum);
  }
  op.laplace.setFromTriplets(entries.begin(), entries.end());
  return op;
}

// Columns become orthonormal in the mass and sorted by eigenvalue (Rayleigh and Ritz).
void sort_out(const Operator& op, Eigen::MatrixXd& basis) {
  const Eigen::MatrixXd stiff = basis.transpose() * (op.laplace * basis);
  const Eigen::MatrixXd mass = basis.transpose() * op.mass.asDiagonal() * basis;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(stiff, mass);
  basis = (basis * small.eigenvectors()).eval();
}

}  // namespace

std::vector<std::vector<double>> low_eigenvectors(const DualGraph& graph, const std::vector<int>& faces, int count) {
  const int n = static_cast<int>(faces.size());
  const int wanted = std::min(count, n - 1);
  const int size = std::min(wanted + 1 + kGuardVectors, n);
  if (wanted < 1) return {};
  const Operator op = laplace_of(graph, faces);
  Sparse shifted = op.laplace;
  const double shift = kShift * op.laplace.diagonal().mean();
  for (int i = 0; i < n; ++i) shifted.coeffRef(i, i) += shift * op.mass[i] * n;
  const Eigen::SimplicialLDLT<Sparse> factors(shifted);
  Eigen::MatrixXd basis(n, size);
  Rng rng(kStartVectors);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < n; ++i) basis(i, j) = j == 0 ? 1 : rng.normal();
  for (int round = 0; round < kRounds; ++round) {
    basis = factors.solve(op.mass.asDiagonal() * basis).eval();
    sort_out(op, basis);
  }
  std::vector<std::vector<double>> result;
  for (int j = 1; j <= wanted; ++j) result.emplace_back(basis.col(j).data(), basis.col(j).data() + n);
  return result;
}

}  // namespace plico
