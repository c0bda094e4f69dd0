#include "plico/workflow/unfold_mesh.h"

#include <algorithm>
#include <chrono>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/classic.h"
#include "plico/unfold/parts.h"

namespace plico {
namespace {

double seconds_since(Run::Clock::time_point start) {
  return std::chrono::duration<double>(Run::Clock::now() - start).count();
}

void search(const Mesh& mesh, const UnfoldOptions& options, const Run& run, UnfoldOutcome& outcome) {
  SearchResult found = find_net(mesh, options.search, run);
  outcome.ending = found.ending;
  outcome.forest = std::move(found.forest);
  outcome.steps = found.steps;
  outcome.start_overlaps = found.start_overlaps;
  outcome.proven_impossible = found.proven_impossible;
  outcome.in_the_way = std::move(found.in_the_way);
}

void classic(const Mesh& mesh, const UnfoldOptions& options, const Run& run, UnfoldOutcome& outcome) {
  const ClassicOptions classic_options{options.search.seed, *options.heuristic, options.directions};
  ClassicResult found = classic_net(mesh, classic_options, run);
  outcome.ending = found.ending;
  outcome.forest = std::move(found.forest);
  outcome.start_overlaps = found.overlaps;
}

EvolveOptions evolve_options(const UnfoldOptions& options) {
  EvolveOptions evolution = options.evolution;
  evolution.seed = options.search.seed;
  return evolution;
}

void evolve(const Mesh& mesh, const UnfoldOptions& options, const Run& run, UnfoldOutcome& outcome) {
  EvolveResult found = evolve_net(mesh, evolve_options(options), run);
  outcome.ending = found.ending;
  outcome.forest = std::move(found.forest);
  outcome.steps = found.generations;
  outcome.start_overlaps = found.start_overlaps;
  outcome.in_the_way = std::move(found.in_the_way);
}

void find_forest(const Mesh& mesh, const UnfoldOptions& options, const Run& run, UnfoldOutcome& outcome) {
  if (options.heuristic)
    classic(mesh, options, run, outcome);
  else if (options.evolve)
    evolve(mesh, options, run, outcome);
  else
    search(mesh, options, run, outcome);
}

void add(NetFeatures& sum, const NetFeatures& one) {
  sum.cut_length += one.cut_length;
  sum.hull_area += one.hull_area;
  sum.box_area += one.box_area;
  sum.longest_branch += one.longest_branch;
}

void optimize(const Mesh& mesh, const UnfoldOptions& options, const Run& run, UnfoldOutcome& outcome) {
  outcome.forest = by_component(mesh, [&](const Submesh& part, int c) {
    FoldForest net{std::vector<char>(part.mesh.num_edges(), 0)};
    for (EdgeId e : part.mesh.edges()) net.is_fold[e] = outcome.forest.is_fold[part.edge[e]];
    OptimizeOptions own = *options.optimize;
    own.seed = Rng(options.search.seed).stream(c).next();
    OptimizeResult better = optimize_net(part.mesh, net, own, run);
    add(outcome.first, better.before);
    add(outcome.best, better.after);
    return std::move(better.forest);
  });
}

// The judge looks closer than the searches do. What it finds is cut apart and judged again: each round cuts, so that at
// last panels stand alone.
void lay_flat_and_judge(const Mesh& mesh, UnfoldOutcome& outcome) {
  for (;;) {
    outcome.unfolding = lay_flat(mesh, outcome.forest);
    outcome.verdict = verify_net(outcome.unfolding, mesh);  // never cut short: whatever is returned has been judged
    std::vector<std::pair<int, int>> pairs;
    for (const OverlappingPair& pair : outcome.verdict.overlaps.listed) pairs.emplace_back(pair.a, pair.b);
    const FoldForest before = outcome.forest;
    part_pairs(mesh, outcome.forest, pairs);
    if (outcome.forest == before) return;
    outcome.ending = Ending::Exhausted;
    outcome.in_the_way.insert(outcome.in_the_way.end(), pairs.begin(), pairs.end());
  }
}

}  // namespace

void check(const UnfoldOptions& options) {
  check(options.search);
  if (options.optimize) check(*options.optimize);
  if (options.heuristic) check(ClassicOptions{options.search.seed, *options.heuristic, options.directions});
  if (options.evolve) check(evolve_options(options));
}

UnfoldOutcome unfold_mesh(const Mesh& mesh, const UnfoldOptions& options, const Run& run) {
  check(options);
  UnfoldOutcome outcome;
  const auto start = Run::Clock::now();
  find_forest(mesh, options, run, outcome);
  outcome.search_seconds = seconds_since(start);
  const auto searched = Run::Clock::now();
  if (options.optimize && outcome.ending == Ending::Found) optimize(mesh, options, run, outcome);
  outcome.optimize_seconds = seconds_since(searched);
  const auto found = Run::Clock::now();
  lay_flat_and_judge(mesh, outcome);
  outcome.verify_seconds = seconds_since(found);
  if (outcome.ending == Ending::Found && !outcome.verified()) outcome.ending = Ending::Exhausted;
  return outcome;
}

std::vector<std::string> unfold_methods() {
  std::vector<std::string> names{"search", "eu"};
  for (Heuristic heuristic : kHeuristics) names.emplace_back(name(heuristic));
  return names;
}

void set_method(UnfoldOptions& options, std::string_view method) {
  options.heuristic.reset();
  options.evolve = method == "eu";
  if (method == "search" || method == "eu") return;
  const auto* at = std::find_if(kHeuristics.begin(), kHeuristics.end(), [&](Heuristic h) { return name(h) == method; });
  if (at == kHeuristics.end()) throw InvalidOption(fmt::format("method {} is not known", method));
  options.heuristic = *at;
}

}  // namespace plico
