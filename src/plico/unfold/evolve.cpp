#include "plico/unfold/evolve.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/genes.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/overlap.h"
#include "plico/unfold/parts.h"

namespace plico {
namespace {

constexpr std::array kFirstHeuristics = {Heuristic::SteepestEdge, Heuristic::FlatTree, Heuristic::MinimumPerimeter};

// The evolution of one connected mesh.
class Evolution {
 public:
  Evolution(const Mesh& mesh, const EvolveOptions& options, const Rng& rng, const Run& run)
      : faces_(mesh), count_(faces_), options_(options), rng_(rng), run_(run) {}

  EvolveResult go() {
    EvolveResult result;
    found_first_population();
    result.start_overlaps = count_(tree_of(genes_[fittest()])).overlaps;
    result.ending = evolve(result.generations);
    const FoldForest tree = tree_of(genes_[fittest()]);
    result.in_the_way = overlapping_pairs(faces_, lay_panels(faces_, tree));
    result.overlaps = static_cast<int>(result.in_the_way.size());
    result.forest = part_overlaps(faces_, tree);
    return result;
  }

 private:
  struct Child {
    Genes genes;
    double fitness = 0;
    bool born = false;  // not when the run ended first
  };

  void found_first_population() {
    std::vector<Child> first(options_.population);
    parallel_for(run_, options_.population, [&](int i) {
      if (i > 0 && run_.over()) return;
      Rng own = rng_.stream(i);
      const Vec3 direction = random_direction(own);
      first[i].genes = dual_weights(faces_.mesh(), kFirstHeuristics[i % kFirstHeuristics.size()], direction, own);
      judge(first[i]);
    });
    for (Child& child : first) {
      if (!child.born) continue;
      genes_.push_back(std::move(child.genes));
      fitness_.push_back(child.fitness);
    }
  }

  Ending evolve(int& generation) {
    for (;; ++generation) {
      if (fitness_[fittest()] == 0) return Ending::Found;
      if (run_.over()) return run_.ending();
      if (generation == options_.max_generations) return Ending::Exhausted;
      run_.report("evolving unfoldings", generation, options_.max_generations,
                  fmt::format("best fitness {}", fitness_[fittest()]));
      std::vector<Child> children = breed(generation);
      if (!std::all_of(children.begin(), children.end(), [](const Child& child) { return child.born; }))
        return run_.ending();
      replace_worst(children);
    }
  }

  std::vector<Child> breed(int generation) const {
    std::vector<Child> children(options_.children);
    const long first_stream = options_.population + static_cast<long>(generation) * options_.children;
    parallel_for(run_, options_.children, [&](int i) {
      if (run_.over()) return;
      Rng own = rng_.stream(first_stream + i);
      const Genes& mother = genes_[tournament(fitness_, options_.tournament, own)];
      children[i].genes = own.uniform() < options_.crossover_probability
                              ? uniform_crossover(mother, genes_[tournament(fitness_, options_.tournament, own)], own)
                              : mother;
      mutate(children[i].genes, options_.mutation_probability, options_.mutation_variance, own);
      judge(children[i]);
    });
    return children;
  }

  void judge(Child& child) const {
    const Faults faults = count_(tree_of(child.genes));
    child.fitness = -(options_.overlap_weight * faults.overlaps + options_.local_weight * faults.local_overlaps);
    child.born = true;
  }

  // Ties go by place in the population, which no thread decides.
  void replace_worst(std::vector<Child>& children) {
    std::vector<int> order(genes_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return fitness_[a] < fitness_[b]; });
    for (std::size_t i = 0; i < children.size(); ++i) {
      genes_[order[i]] = std::move(children[i].genes);
      fitness_[order[i]] = children[i].fitness;
    }
  }

  FoldForest tree_of(const Genes& genes) const { return lightest_forest(faces_.mesh(), genes); }
  int fittest() const {
    return static_cast<int>(std::max_element(fitness_.begin(), fitness_.end()) - fitness_.begin());
  }

  const FlatFaces faces_;
  const FaultCounter count_;
  const EvolveOptions& options_;
  const Rng& rng_;
  const Run& run_;
  std::vector<Genes> genes_;
  std::vector<double> fitness_;
};

void check_probability(const char* field, double value) {
  if (!(value >= 0 && value <= 1)) throw InvalidOption(fmt::format("{} = {} must be in [0, 1]", field, value));
}

}  // namespace

void check(const EvolveOptions& options) {
  const int p = options.population;
  if (p < 2) throw InvalidOption(fmt::format("population = {} must be at least 2", p));
  if (options.tournament < 1 || options.tournament > p)
    throw InvalidOption(fmt::format("tournament = {} must be in [1, population = {}]", options.tournament, p));
  if (options.children < 1 || options.children >= p)
    throw InvalidOption(fmt::format("children = {} must be in [1, population - 1 = {}]", options.children, p - 1));
  check_probability("crossover-probability", options.crossover_probability);
  check_probability("mutation-probability", options.mutation_probability);
  if (!(options.mutation_variance >= 0))
    throw InvalidOption(fmt::format("mutation-variance = {} must be at least 0", options.mutation_variance));
  if (!(options.overlap_weight > 0))
    throw InvalidOption(fmt::format("overlap-weight = {} must be above 0", options.overlap_weight));
  if (!(options.local_weight >= 0))
    throw InvalidOption(fmt::format("local-weight = {} must be at least 0", options.local_weight));
  if (options.max_generations < 0)
    throw InvalidOption(fmt::format("max-generations = {} must be at least 0", options.max_generations));
}

EvolveResult evolve_net(const Mesh& mesh, const EvolveOptions& options, const Run& run) {
  check(options);
  EvolveResult whole;
  whole.ending = Ending::Found;
  whole.forest = by_component(mesh, [&](const Submesh& part, int c) {
    const Rng rng = Rng(options.seed).stream(c);
    EvolveResult own = Evolution(part.mesh, options, rng, run).go();
    if (own.ending != Ending::Found) whole.ending = own.ending;
    whole.start_overlaps += own.start_overlaps;
    whole.overlaps += own.overlaps;
    whole.generations = std::max(whole.generations, own.generations);
    for (const auto& [a, b] : own.in_the_way) whole.in_the_way.emplace_back(part.face[a], part.face[b]);
    return std::move(own.forest);
  });
  whole.parts = count_parts(mesh, whole.forest);
  return whole;
}

}  // namespace plico
