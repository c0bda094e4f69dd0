// From a mesh to a verified unfolding: search by the method asked for, lay out, judge.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plico/fold/unfolding.h"
#include "plico/unfold/evolve.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/optimize.h"
#include "plico/unfold/search.h"
#include "plico/verify/net.h"

namespace plico {

struct UnfoldOptions {
  // Empty: our own search. Otherwise the trees of one classic heuristic, `directions` of them.
  std::optional<Heuristic> heuristic;
  int directions = 20;
  bool evolve = false;  // EU instead of our own search, by `evolution`; `heuristic` must be empty
  EvolveOptions evolution;
  SearchOptions search;                     // its seed serves every method
  std::optional<OptimizeOptions> optimize;  // the net of every component, once it is found
};
void check(const UnfoldOptions& options);  // throws InvalidOption

struct UnfoldOutcome {
  Ending ending = Ending::Exhausted;  // Found: one verified net for every component
  FoldForest forest;
  Unfolding unfolding;
  NetVerdict verdict;
  long steps = 0;                               // of the search; generations of EU
  int start_overlaps = 0;                       // pairs, in the trees the method set out from
  bool proven_impossible = false;               // no net exists
  std::vector<std::pair<int, int>> in_the_way;  // mesh faces that had to be cut apart
  NetFeatures first, best;  // sums over the components, before and after `optimize`; zero without it
  double search_seconds = 0, optimize_seconds = 0, verify_seconds = 0;

  bool verified() const { return verdict.valid(); }
};

// The unfolding never overlaps: where no single net was found it has more parts than the mesh has components.
UnfoldOutcome unfold_mesh(const Mesh& mesh, const UnfoldOptions& options = {}, const Run& run = {});

// "search", "eu" or a heuristic's name, as users write it.
std::vector<std::string> unfold_methods();
void set_method(UnfoldOptions& options, std::string_view method);  // throws InvalidOption

}  // namespace plico
