#include "plico/workflow/unfold_mesh.h"

#include <algorithm>
#include <chrono>

#include "plico/base/error.h"
#include "plico/unfold/classic.h"

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

}  // namespace

void check(const UnfoldOptions& options) {
  check(options.search);
  if (options.heuristic) check(ClassicOptions{options.search.seed, *options.heuristic, options.directions});
  if (options.evolve) check(evolve_options(options));
}

UnfoldOutcome unfold_mesh(const Mesh& mesh, const UnfoldOptions& options, const Run& run) {
  check(options);
  UnfoldOutcome outcome;
  const auto start = Run::Clock::now();
  find_forest(mesh, options, run, outcome);
  outcome.search_seconds = seconds_since(start);
  const auto found = Run::Clock::now();
  outcome.unfolding = lay_flat(mesh, outcome.forest);
  // The judge is never cut short: whatever is returned has been judged.
  outcome.verdict = verify_net(outcome.unfolding, mesh);
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
