#include "plico/segment/clusters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "plico/base/error.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

constexpr int kSpectralRounds = 40;
constexpr int kMeansTries = 5, kMeansRounds = 50;

// The k - 1 vectors next to the constant one of D^-1 M, one row a face.
Eigen::MatrixXd spectral_places(const Foldability& foldability, const std::vector<int>& faces, int k, Rng& rng) {
  const int n = static_cast<int>(faces.size());
  Eigen::MatrixXd similar(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) similar(i, j) = foldability(faces[i], faces[j]);
  const Eigen::VectorXd root = similar.rowwise().sum().cwiseMax(1e-12).cwiseSqrt();
  similar = (root.cwiseInverse().asDiagonal() * similar * root.cwiseInverse().asDiagonal()).eval();
  // Eigenvalues in [0, 2], so that iteration finds the largest and not the most negative; 0 for the constant.
  similar.diagonal().array() += 1;
  const Eigen::VectorXd constant = root.normalized();
  similar -= 2 * constant * constant.transpose();
  const int wanted = std::min(k, n) - 1, size = std::min(n, wanted + 4);
  Eigen::MatrixXd basis(n, size);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < n; ++i) basis(i, j) = rng.normal();
  for (int round = 0; round < kSpectralRounds; ++round) {
    basis = (similar * basis).eval();
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(basis);
    basis = factors.householderQ() * Eigen::MatrixXd::Identity(n, size);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(basis.transpose() * similar * basis);
  basis = (basis * small.eigenvectors().rowwise().reverse()).eval();  // the largest first
  return root.cwiseInverse().asDiagonal() * basis.leftCols(wanted);
}

struct Means {
  std::vector<int> cluster;
  double spread = std::numeric_limits<double>::infinity();  // sum of squares
};

// Centres to begin with are drawn in proportion to the squared distance from those drawn (Arthur and Vassilvitskii
// 2007).
Eigen::MatrixXd first_centres(const Eigen::MatrixXd& places, int k, Rng& rng) {
  const int n = static_cast<int>(places.rows());
  Eigen::MatrixXd centres(k, places.cols());
  centres.row(0) = places.row(rng.below(n));
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  for (int c = 1; c < k; ++c) {
    for (int i = 0; i < n; ++i) nearest[i] = std::min(nearest[i], (places.row(i) - centres.row(c - 1)).squaredNorm());
    double left = rng.uniform() * nearest.sum();
    int chosen = 0;
    while (chosen + 1 < n && (left -= nearest[chosen]) > 0) ++chosen;
    centres.row(c) = places.row(chosen);
  }
  return centres;
}

Means means_from(const Eigen::MatrixXd& places, Eigen::MatrixXd centres) {
  const int n = static_cast<int>(places.rows()), k = static_cast<int>(centres.rows());
  Means means;
  means.cluster.assign(n, -1);
  for (int round = 0; round < kMeansRounds; ++round) {
    bool moved = false;
    means.spread = 0;
    for (int i = 0; i < n; ++i) {
      int best = 0;
      const double least = (centres.rowwise() - places.row(i)).rowwise().squaredNorm().minCoeff(&best);
      means.spread += least;
      moved |= means.cluster[i] != best;
      means.cluster[i] = best;
    }
    if (!moved) break;
    for (int c = 0; c < k; ++c) {
      Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(places.cols());
      int count = 0;
      for (int i = 0; i < n; ++i)
        if (means.cluster[i] == c) sum += places.row(i), ++count;
      if (count > 0) centres.row(c) = sum / count;
    }
  }
  return means;
}

// Makes clusters connected; `cluster` has one entry for each of `faces`.
class ClusterRepair {
 public:
  ClusterRepair(const DualGraph& graph, const Foldability& foldability, const std::vector<int>& faces,
                std::vector<int> cluster, int k)
      : graph_(graph), foldability_(foldability), faces_(faces), cluster_(std::move(cluster)), k_(k) {
    local_.assign(graph.num_faces(), -1);
    for (std::size_t i = 0; i < faces.size(); ++i) local_[faces[i]] = static_cast<int>(i);
  }

  std::vector<int> run() {
    for (int c = 0; c < k_; ++c) keep_largest(c);
    while (give_away_loose_faces()) {
    }
    return number_again();
  }

 private:
  void keep_largest(int c) {
    std::vector<char> seen(faces_.size(), 0);
    std::vector<int> largest;
    for (std::size_t first = 0; first < faces_.size(); ++first) {
      if (cluster_[first] != c || seen[first]) continue;
      std::vector<int> piece{static_cast<int>(first)};
      seen[first] = 1;
      for (std::size_t i = 0; i < piece.size(); ++i)
        for (const DualGraph::Arc& arc : graph_.arcs(faces_[piece[i]]))
          if (const int j = local_[arc.to]; j >= 0 && cluster_[j] == c && !seen[j]) seen[j] = 1, piece.push_back(j);
      if (piece.size() > largest.size()) largest = piece;
    }
    for (int& own : cluster_)
      if (own == c) own = -1;
    for (int i : largest) cluster_[i] = c;
  }

  double pull(int i, int c) const {
    double sum = 0;
    for (std::size_t j = 0; j < faces_.size(); ++j)
      if (cluster_[j] == c) sum += graph_.area(faces_[j]) * foldability_(faces_[i], faces_[j]);
    return sum;
  }

  bool give_away_loose_faces() {
    bool any = false;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (cluster_[i] >= 0) continue;
      int best = -1;
      double most = -1;
      for (const DualGraph::Arc& arc : graph_.arcs(faces_[i])) {
        const int j = local_[arc.to];
        if (j < 0 || cluster_[j] < 0 || cluster_[j] == best) continue;
        if (const double sum = pull(static_cast<int>(i), cluster_[j]); sum > most) most = sum, best = cluster_[j];
      }
      if (best >= 0) cluster_[i] = best, any = true;
    }
    return any;
  }

  std::vector<int> number_again() {
    std::vector<int> number(k_, -1), result;
    int next = 0;
    for (int c : cluster_) {
      if (number[c] < 0) number[c] = next++;
      result.push_back(number[c]);
    }
    return result;
  }

  const DualGraph& graph_;
  const Foldability& foldability_;
  const std::vector<int>& faces_;
  std::vector<int> cluster_, local_;
  int k_;
};

}  // namespace

Foldability::Foldability(const Mesh& mesh, int trials, const std::function<UnfoldingTrial(int)>& unfold, const Run& run)
    : size_(mesh.num_faces()), counts_(size_ * size_, 0) {
  for (int i = 0; i < trials && (i == 0 || !run.over()); ++i) {
    run.report("unfolding at random", i, trials);
    add(mesh, unfold(i));
  }
}

void Foldability::add(const Mesh& mesh, const UnfoldingTrial& trial) {
  std::vector<std::vector<int>> across(size_), over(size_);
  for (EdgeId e : mesh.edges()) {
    if (!trial.is_fold[e]) continue;
    const int a = mesh.face(mesh.halfedge(e)), b = mesh.face(mesh.twin(mesh.halfedge(e)));
    across[a].push_back(b);
    across[b].push_back(a);
  }
  for (const auto& [a, b] : trial.overlaps) over[a].push_back(b), over[b].push_back(a);
  std::vector<int> blocked(size_, -1), seen(size_, -1), piece;
  for (int f = 0; f < static_cast<int>(size_); ++f) {
    piece.assign(1, f);
    seen[f] = f;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int g = piece[i];
      counts_[f * size_ + g] += 1;
      if (g != f) counts_[g * size_ + f] += 1;
      for (int h : over[g]) blocked[h] = f;
      for (int h : across[g])
        if (seen[h] != f && blocked[h] != f) {
          // A face that joins keeps out what it overlaps from now on.
          seen[h] = f;
          for (int x : over[h]) blocked[x] = f;
          piece.push_back(h);
        }
    }
  }
}

std::vector<int> cluster(const DualGraph& graph, const Foldability& foldability, const std::vector<int>& faces, int k,
                         std::uint64_t seed) {
  k = std::min(k, static_cast<int>(faces.size()));
  if (k <= 1) return std::vector<int>(faces.size(), 0);
  Rng rng(seed);
  const Eigen::MatrixXd places = spectral_places(foldability, faces, k, rng);
  Means best;
  for (int i = 0; i < kMeansTries; ++i) {
    const Eigen::MatrixXd centres = first_centres(places, k, rng);
    if (Means means = means_from(places, centres); means.spread < best.spread) best = std::move(means);
  }
  if (best.cluster.empty()) best.cluster.assign(faces.size(), 0);
  return ClusterRepair(graph, foldability, faces, std::move(best.cluster), k).run();
}

std::vector<int> random_parts(const DualGraph& graph, const std::vector<int>& faces, int k, std::uint64_t seed) {
  require(k >= 1 && k <= static_cast<int>(faces.size()), "parts", k, "at least 1 and at most the number of faces");
  Rng rng(seed);
  std::vector<int> local(graph.num_faces(), -1), part(faces.size(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i) local[faces[i]] = static_cast<int>(i);
  std::vector<std::pair<int, int>> border;  // face, part that may take it
  const auto take = [&](int i, int p) {
    part[i] = p;
    for (const DualGraph::Arc& arc : graph.arcs(faces[i]))
      if (local[arc.to] >= 0 && part[local[arc.to]] < 0) border.emplace_back(local[arc.to], p);
  };
  for (int p = 0; p < k; ++p) {
    int first = rng.below(static_cast<int>(faces.size()));
    while (part[first] >= 0) first = (first + 1) % static_cast<int>(faces.size());
    take(first, p);
  }
  while (!border.empty()) {
    const int at = rng.below(static_cast<int>(border.size()));
    const auto [i, p] = border[at];
    border[at] = border.back();
    border.pop_back();
    if (part[i] < 0) take(i, p);
  }
  return part;
}

}  // namespace plico
