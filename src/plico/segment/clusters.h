// Parts learned from failed unfoldings. Source: [Xi17] 4.2, read as R16. The baseline that
// necks are measured against.
#pragma once
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/segment/dual_graph.h"

namespace plico {

// One unfolding of the whole mesh: its tree, and what overlaps when it lies flat.
struct UnfoldingTrial {
  std::vector<char> is_fold;                  // one entry a mesh edge
  std::vector<std::pair<int, int>> overlaps;  // pairs of faces
};

// How often two faces lie in one piece of an unfolding that does not overlap itself: a dense matrix, 4 n^2 bytes.
class Foldability {
 public:
  // Adds up `trials` unfoldings. From every face a piece grows over folds of the tree, breadth first, by faces that
  // overlap none that is in it already. O(trials n (n + overlaps)).
  Foldability(const Mesh& mesh, int trials, const std::function<UnfoldingTrial(int)>& unfold, const Run& run = {});

  float operator()(int f, int g) const { return counts_[static_cast<std::size_t>(f) * size_ + g]; }

 private:
  void add(const Mesh& mesh, const UnfoldingTrial& trial);

  std::size_t size_;
  std::vector<float> counts_;
};

// Cuts connected faces in `k` connected parts (fewer when clusters are empty): spectral clustering of the foldability
// by normalized cuts (Shi and Malik 2000) and the best of five k-means; then of every cluster the largest piece is
// kept, and every other face goes to the neighbouring part with the largest area times foldability. Returns 0..k-1 for
// each of `faces`. O(n^2 k).
std::vector<int> cluster(const DualGraph& graph, const Foldability& foldability, const std::vector<int>& faces, int k,
                         std::uint64_t seed);

// `k` connected parts that grow from random faces by random neighbours, for connected faces; 1 <= k <= faces. O(n).
std::vector<int> random_parts(const DualGraph& graph, const std::vector<int>& faces, int k, std::uint64_t seed);

}  // namespace plico
