// Planning a motion from the flat sheet to the folded shape when the straight one collides.
// Source: [Xi17] 4.3: sample each fold angle from {0, target} only, and search a roadmap that is checked lazily.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"

namespace plico {

enum class Planner { LazyPrm, Prm, RrtConnect };  // of the Open Motion Planning Library, over the same space
std::string_view name(Planner planner);           // "lazy-prm", "prm", "rrt-connect"

struct PlannerOptions {
  std::uint64_t seed = 1;  // lazy-prm and rrt-connect repeat for a seed; prm grows its roadmap by the clock
  Planner planner = Planner::LazyPrm;
  double clearance = 0;       // units; 0: 1e-3 of the mean side length
  double resolution = 0.005;  // states along a connection are checked at this fraction of the space's extent, in (0, 1]
  long max_states = 0;        // checked for collision; 0: most_states() of the linkage; at least 0
};
void check(const PlannerOptions& options);  // throws InvalidOption naming field, value and range

// States that place as many panels in all as a planner may by default, 10 million: up to 10 s.
long most_states(const Linkage& linkage);

struct PlannedPath {
  Ending ending = Ending::Exhausted;
  FoldingPath path;         // Found only: from flat to goal, free at the states that were checked
  long states_checked = 0;  // for collision, samples that were dropped included
};

// Searches backward, from the folded state, because that end is the narrow one; the path runs from flat to goal. Gives
// up after max_states. Samples are folded creases picked at random, evenly, from the tips of the tree inward, or from
// its root outward; samples that collide are dropped. Uses OMPL, each planner with a seed of its own.
// Throws InvalidInput "fold/limits" for a goal beyond the limits of a hinge: angles stay between flat and the goal.
PlannedPath plan_path(const Linkage& linkage, const PlannerOptions& options = {}, const Run& run = {});

// OMPL tells what it does on standard output, through a handler of the whole process, which is the program's to set and
// not the library's: programs that do not want that call this once, before any planning.
void silence_planners();

// Whether this build has OMPL. Without it plan_path() throws InvalidOption.
bool has_planners();

// Can one path be bent straight into the other? False when a blend of the two collides at one of the samples: evidence,
// not proof, that they belong to different homotopy classes.
bool blends_freely(const Linkage& linkage, const FoldingPath& a, const FoldingPath& b, double clearance = 0);

// How the valid part of configuration space looks to a sampler ([Xi17] fig. 4.6): of `samples` configurations, each
// fold angle drawn from {0, target} or uniformly in between, the fraction without collision.
struct ValidRatio {
  double discrete = 0, uniform = 0;
};
ValidRatio valid_ratio(const Linkage& linkage, int samples, std::uint64_t seed = 1, double clearance = 0);

}  // namespace plico
