// The joint search for a net and its motion: a local search over spanning trees whose objective counts overlaps of the
// flat panels and, through an interface filled by whoever knows motions, collisions on the way to the folded shape.
// The question is the one that [Xi17] 7.1 leaves open: nets that are linearly foldable.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"

namespace plico {

// How badly a net folds, kept up to date while branches are hung elsewhere. Faces are those of the mesh; `side` is a
// halfedge of a face of the branch whose twin lies outside.
class MotionCost {
 public:
  virtual ~MotionCost() = default;
  virtual void reset(const FoldForest& tree) = 0;

  virtual long cost() const = 0;                              // 0: no collision seen so far
  virtual std::pair<int, int> conflict(long i) const = 0;     // two faces that collide, i in [0, cost())
  virtual long cost_across(std::span<const int> branch) = 0;  // the part of cost() between the branch and the rest
  virtual long cost_if_hung(std::span<const int> branch, int side, long limit) = 0;  // the same, hung by `side`
  virtual void hang(std::span<const int> branch, int side) = 0;

  // What has been done so far: in one unit for all that takes time, the same in every run. Never falls.
  virtual long work() const = 0;

  // Asked when cost() is 0 and the net is flat without overlap. Looks closer: Free ends the search; Seen has found
  // collisions and raised cost(); Unclear found none but cannot say that there are none.
  enum class Closer { Free, Seen, Unclear };
  virtual Closer look_closer(const FoldForest& tree, const Run& run) = 0;
};

struct FoldableOptions {
  std::uint64_t seed = 1;        // same mesh, same options: same result for every thread count, if allowed to finish
  int lanes = 2;                 // searches side by side, from their own starts; at least 1
  int overlap_weight = 1;        // of an overlap of flat panels, against one colliding pair at one sample; at least 1
  double temperature = 6;        // at the start of a cooling: worse by this much is accepted with probability 1/e; > 0
  double nearby = 0.6;           // of the branches are cut close to a conflict, not between the two in conflict; [0, 1]
  double coldest = 0.7;          // temperature at the end of a cooling; [0, temperature]
  double seams = 0.5;            // of the branches are hung close to the conflict, if that can be; [0, 1]
  int steps_per_cooling = 40;    // times the number of faces; then it is warmed up again; at least 1
  int steps_per_recooling = 25;  // the same, of every later cooling; at least 1
  long max_steps = 50'000'000;   // of each lane
};
void check(const FoldableOptions& options);  // throws InvalidOption naming field, value and range

struct FoldableResult {
  Ending ending = Ending::Exhausted;
  FoldForest tree;      // Found: a net that folds. Otherwise the net with fewest collisions; if no net was seen, a tree
  long overlaps = 0;    // of the flat panels of `tree`
  long collisions = 0;  // cost() of `tree`; 0 too when the time was over before any was counted
  long steps = 0;       // branches tried by the lane that `tree` is of
};

// The mesh must be connected; `start(lane)` gives the spanning trees to set out from (nets, or nearly). A step picks a
// pair in conflict, cuts a fold edge on the tree path between them, or close to one of them where something may stand
// in the way of both, and hangs the branch elsewhere, half of the time close to the conflict; a worse tree is accepted
// as in simulated annealing, with the bound drawn first, so that a bad hanging is dropped at its first few collisions.
FoldableResult anneal_foldable_net(const Mesh& mesh, const std::function<FoldForest(int lane)>& start,
                                   const std::function<std::unique_ptr<MotionCost>()>& new_cost,
                                   const FoldableOptions& options = {}, const Run& run = {});

}  // namespace plico
