// FROG, folding rigid origami: a randomized planner that extends one path towards the goal.
// Source: [Xi17] algorithm 1, read as R5.
#pragma once
#include <cstdint>
#include <memory>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/motion/collision.h"
#include "plico/origami/nlopt_projection.h"
#include "plico/origami/projector.h"

namespace plico {

enum class FindFoldable { GaussNewton, Nlopt };

// [Xi17] states neither D nor the weights.
struct FrogOptions {
  std::uint64_t seed = 1;
  double step = 0.1;            // D: Euclidean, radians; above 0
  double initial_weight = 0.9;  // W0: of the goal against a random configuration, kept in [0, 1]
  double reward = 0.1;          // W1: added after a sample that comes closer; at least 0
  double penalty = 0.1;         // W2: subtracted after any other; at least 0
  long max_samples = 20000;     // at least 1
  long patience = 20000;        // samples without coming half of D closer before it gives up, at least 1
  FindFoldable find = FindFoldable::GaussNewton;
  double tolerance = 1e-12;  // radians: residual of a waypoint that closes; above 0
  NloptOptions nlopt = {};   // of Nlopt: what it finds, the projection closes tightly; its limits must be empty
  CollisionOptions collision = {};
  bool check_collisions = true;
};

// As table 3.1 counts them.
struct FrogCounts {
  long sampled = 0;  // random configurations
  long valid = 0;    // of those: closed near the last waypoint and free of collision
  long tested = 0;   // configurations whose loops were walked around
};

struct FrogResult {
  Ending ending = Ending::Exhausted;
  FoldingPath path;  // as far as it got; `time` is the share of the length of the path, 1 at the last waypoint
  FrogCounts counts;
  double distance = 0;        // to the goal at the end, Euclidean, radians
  double worst_residual = 0;  // of all waypoints, radians
};

// One sheet's planner, for many queries. Every crease stays between flat and fully folded on the side of its target,
// and within the limits of its hinge.
class Frog {
 public:
  // Throws InvalidOption, and InvalidInput as require_closable() does.
  explicit Frog(const Linkage& linkage, const FrogOptions& options = {});
  ~Frog();
  Frog(Frog&&) noexcept;
  Frog& operator=(Frog&&) noexcept;

  // From `start` to `goal`, both closed and within the limits (else Exhausted at once). The goal is reached from at
  // most D away. A sample counts as valid only when it lies within 2 D of the waypoint before it: one that the
  // projection took farther may be on another branch. Deterministic for the seed.
  FrogResult plan(const Configuration& start, const Configuration& goal, const Run& run = {});

  void set_patience(long samples);  // of the queries to come

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

// From flat to the targets of the hinges.
FrogResult frog(const Linkage& linkage, const FrogOptions& options = {}, const Run& run = {});
inline FrogResult frog(const CreasePattern& sheet, const FrogOptions& options = {}, const Run& run = {}) {
  return frog(make_linkage(sheet), options, run);
}

}  // namespace plico
