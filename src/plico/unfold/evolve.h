// EU, the genetic search for a net of [Xi17] 4.1: the baseline that our own search (search.h) is measured against.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"

namespace plico {

// Defaults are those of [Xi17] 4.1.5.
struct EvolveOptions {
  std::uint64_t seed = 1;             // same mesh, same options: same result on every machine and thread count
  int population = 400;               // at least 2
  int tournament = 7;                 // individuals compared for one pick, in [1, population]
  int children = 50;                  // that replace the worst each generation, in [1, population - 1]
  double crossover_probability = .4;  // that a child has two parents rather than one, in [0, 1]
  double mutation_probability = .02;  // that a gene of a child changes, in [0, 1]
  double mutation_variance = .3;      // of the Gaussian added to it, at least 0; genes are weights in [0, 1]
  double overlap_weight = 1;          // lambda_o, above 0
  double local_weight = 10;           // lambda_l, at least 0
  int max_generations = 5000;         // at least 0
};
void check(const EvolveOptions& options);  // throws InvalidOption naming field, value and range

struct EvolveResult {
  Ending ending = Ending::Exhausted;
  FoldForest forest;  // never overlaps; one part per component of the mesh exactly when ending is Found
  int parts = 0;
  int start_overlaps = 0;  // overlapping pairs of panels in the fittest trees of the first population
  int overlaps = 0;        // and of the last, before cutting
  int generations = 0;     // of the component that took most; as max_generations it repeats a run that was timed out
  // Pairs of mesh faces that still overlapped when the search ended and were then cut apart.
  std::vector<std::pair<int, int>> in_the_way;
};

// Weights of dual edges evolve, from those of steepest-edge, flat-tree and minimum-perimeter in turn over random
// directions, towards a spanning tree of fitness -(lambda_o N_o + lambda_l N_l) = 0, which is a net.
// A generation takes O(children n log n); memory O(population n).
EvolveResult evolve_net(const Mesh& mesh, const EvolveOptions& options = {}, const Run& run = {});

}  // namespace plico
