// From a linkage to a proven motion, whatever the linkage was made from: a net, a crease pattern, a part of a kit or a
// strip of thick panels.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/motion/planner.h"
#include "plico/verify/path.h"

namespace plico {

// Reuse is no planner: the motion of a smaller sheet was carried over.
enum class MotionMethod { Auto, Linear, Uniform, LazyPrm, RrtConnect, Prm, Continuation, Frog, MdFrog, Reuse };
std::vector<std::string> motion_methods();          // "auto", "linear", ...: the planners, in the order above
MotionMethod motion_method(std::string_view name);  // throws InvalidOption
std::string_view name(MotionMethod method);

// What a planner takes. Of Auto: what the planners take that it tries.
struct PlannerContract {
  bool trees = false, loops = false;  // linkages without loops, and with; else InvalidOption
  bool thickness = false;             // thick panels without loops; with them InvalidInput "fold/thick-loops"
  // A goal beyond the limits of a hinge. Without loops it is refused, InvalidInput "fold/limits". With loops the ending
  // is Exhausted, and the motion goes as far as the limits; or else there is none.
  bool goes_to_limits = false;
};
PlannerContract contract(MotionMethod method);

// Whether panels of a sheet with loops are cut by flat creases along which they bend (plan_origami): when whole ones do
// not reach the goal, never, or all of them.
enum class FacetPolicy { Auto, None, All };
std::vector<std::string> facet_policies();        // "auto", "none", "all"
FacetPolicy facet_policy(std::string_view name);  // throws InvalidOption

struct MotionOptions {
  std::uint64_t seed = 1;
  MotionMethod method = MotionMethod::Auto;  // Auto: linear, else uniform (up to 5,000 hinges), else lazy-prm
  int alternatives = 1;                      // motions wanted, none of which blends straight into another; at least 1
  double clearance = 0;                      // units; 0: 1e-3 of the mean side length
  // With loops:
  int waypoints = 50;                       // aimed at before those that the gap asks for; at least 1
  bool grouped = false;                     // creases of one group turn together (origami/crease_groups.h)
  std::vector<Configuration> through = {};  // states to be passed in this order, by MD-FROG; each must close
  FacetPolicy facets = FacetPolicy::Auto;
  double deformation = 0;  // share by which edges may change their length where exact motions stop early, in [0, 0.1]
  // Without:
  bool may_search = true;  // Auto: false leaves out lazy-prm
  double effort = 1;       // share of most_states() that planners may check, in (0, 1]
};

struct Motion {
  MotionMethod method = MotionMethod::Linear;  // that made it; never Auto
  FoldingPath path;
  PathProof proof;
};

struct MotionOutcome {
  Ending ending = Ending::Exhausted;  // Found: as many proven motions as were wanted
  // At least one for trees; without a proven one, the best: the motion that gets farthest. With loops, a motion that
  // ends early leads as far as the sheet gets, and there is none when it cannot leave the flat state.
  std::vector<Motion> motions;
  double progress = 1;                 // with loops: of the way to the goal, of the motion
  std::vector<std::string> notes;      // with loops: what stood in the way, or was done to get there; sentences
  std::optional<CreasePattern> sheet;  // with loops: that the motions fold, when panels were cut or vertices settled
  std::vector<double> bends;           // panels cut: of each given one, radians at most; 0 stays flat
  double deformation = 0;              // of an edge at most, measured; 0: loops close exactly
  bool proven() const { return !motions.empty() && motions.front().proof.verdict == PathVerdict::Free; }
};

// Every motion handed out as Free was proven by verify/path.h, whoever made it, and keeps the limits of all hinges.
// Without loops: the straight motion, the uniform one, or what a planner finds. With loops: workflow/plan_origami.h.
// Deterministic. Throws what the planner's contract says, InvalidOption for options that are not for such a linkage.
MotionOutcome plan(const Linkage& linkage, const MotionOptions& options = {}, const Run& run = {});

// How often a motion still folds when creases are made inexactly: in each sample every fold angle is off by a random
// amount in [-noise, noise] radians at the goal, in proportion to time before.
struct NoiseVerdict {
  int samples = 0, folded = 0;  // folded: no collision at `steps` states of the motion
  double mean_stop = 1;         // time of the first collision, 1 for those that fold
};
NoiseVerdict fold_with_noise(const Linkage& linkage, const FoldingPath& path, double noise, int samples,
                             std::uint64_t seed = 1, double clearance = 0, const Run& run = {});

}  // namespace plico
