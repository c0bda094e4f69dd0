// What the genetic search for nets is made of: individuals, their fitness, and the operators that breed them.
// Source: [Xi17] 4.1.1, 4.1.2, 4.1.4.
#pragma once
#include <vector>

#include "plico/base/rng.h"
#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"

namespace plico {

// One weight in [0, 1] per mesh edge; the unfolding is the spanning tree of least weight.
using Genes = std::vector<double>;

// What is wrong with an unfolding.
struct Faults {
  int overlaps = 0;        // N_o, pairs of panels
  int local_overlaps = 0;  // N_l, hyperbolic vertices with a fan wider than 2 pi in the net (R7)
};

// Counts the faults of spanning trees of one connected mesh, which must outlive it.
class FaultCounter {
 public:
  explicit FaultCounter(const FlatFaces& faces);

  // O(n + overlaps) for faces of similar size.
  Faults operator()(const FoldForest& tree) const;
  // N_l alone. O(degrees of the hyperbolic vertices).
  int local_overlaps(const FoldForest& tree) const;

 private:
  struct Spoke {
    int edge;      // a fan ends here when it is cut
    double angle;  // of the face after it, in the order around the vertex
  };
  bool has_wide_fan(int vertex, const FoldForest& tree) const;

  const FlatFaces* faces_;
  std::vector<Spoke> spoke_;      // of the hyperbolic vertices, one after the other
  std::vector<int> first_spoke_;  // hyperbolic vertices + 1
};

// The fittest (largest) of `size` individuals drawn with replacement; the first drawn among equals. O(size).
int tournament(const std::vector<double>& fitness, int size, Rng& rng);

// Every gene comes from one of the two parents, each with probability 1/2.
Genes uniform_crossover(const Genes& mother, const Genes& father, Rng& rng);

// Every gene changes with this probability, by a Gaussian of mean 0 and this variance, and stays within [0, 1].
void mutate(Genes& genes, double probability, double variance, Rng& rng);

}  // namespace plico
