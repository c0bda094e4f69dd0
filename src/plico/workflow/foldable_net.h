// From a mesh to a one-piece net with a proven motion: the search of unfold/foldable.h, told by motion/ where a net
// collides and by verify/ when it does not.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/fold/unfolding.h"
#include "plico/motion/branch_sampler.h"
#include "plico/unfold/optimize.h"
#include "plico/verify/path.h"
#include "plico/workflow/plan_motion.h"

namespace plico {

struct FoldableNetOptions {
  std::uint64_t seed = 1;
  FoldingLaw law = FoldingLaw::Linear;
  double clearance = 0;  // units; 0: 1e-3 of the mean side length
  int samples = 16;      // of the motion to begin with; others come where a net that looked free collides; at least 1
  long max_steps = 0;    // branches tried from each start; 0: 20,000 and 300 more a face, at most 1,520,000
};

struct FoldableNet {
  Ending ending = Ending::Exhausted;
  // Found: one net whose motion is proven free; otherwise the net with fewest collisions, or, when none was seen, a
  // forest of several parts. It never overlaps.
  FoldForest tree;
  bool proven_impossible = false;  // every spanning tree overlaps or collides at a sample of its motion
  // Pairs of faces that pass through each other in the mesh itself: every motion of one piece ends in their collision,
  // so nothing was searched.
  std::vector<std::pair<int, int>> crossing;
  long collisions = 0;  // colliding pairs over the samples that the search had in the end
  long steps = 0;       // branches tried
  FoldingPath path;     // of make_linkage(lay_flat(mesh, tree)), by the law
  PathProof proof;      // Free exactly when ending is Found
};

// Meshes of up to kMostJoints edges that resist the search are looked at tree by tree for a while
// (motion/clear_trees.h): some have no net that folds by the law. The mesh must be connected, otherwise throws
// InvalidInput.
FoldableNet find_foldable_net(const Mesh& mesh, const FoldableNetOptions& options = {}, const Run& run = {});

// The net that folds by the law. If the search found none, a net with the best motion that a planner finds
// (workflow/plan_motion.h): of find_net(), or else the search's best. What is asked for the same mesh and options is
// answered the same: counts of steps and of states end the searches, never a clock, unless `run` has a deadline.
struct NetAndMotion {
  FoldableNet net;
  std::optional<Motion> motion;  // proven or not; none for a single panel, several parts or a mesh that crosses itself
};
NetAndMotion fold_or_plan(const Mesh& mesh, const FoldableNetOptions& options = {}, const Run& run = {});

// A better net, by unfold/optimize.h, of one whose motion by options.law is proven: the new one's is, too.
struct BetterNet {
  FoldForest tree;
  FoldingPath path;
  PathProof proof;  // Free
  NetFeatures before, after;
};
BetterNet better_foldable_net(const Mesh& mesh, const FoldForest& tree, const FoldableNetOptions& options,
                              const OptimizeOptions& wish, const Run& run = {});

// Faces that penetrate each other in the mesh itself, smaller first, ascending; never of two components. Neighbours do
// not count: the hinge of some trees keeps them apart. `clearance` in units, 0: 1e-3 of the mean side length.
std::vector<std::pair<int, int>> crossing_faces(const Mesh& mesh, double clearance = 0);

// The linkage of a net, and its motion by a law.
Linkage linkage_of(const Unfolding& net);
FoldingPath path_by(FoldingLaw law, const Linkage& linkage);

}  // namespace plico
