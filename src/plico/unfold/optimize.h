// Better nets from a valid one: shorter cuts, a smaller hull or page, shorter branches, never an overlap.
// Source: [Xi17] 5.5, f = sum of w_i x_i; there a genetic search, here simulated annealing over re-hung branches.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"
#include "plico/unfold/foldable.h"

namespace plico {

struct NetFeatures {
  double cut_length = 0;      // of the mesh edges that are cut, each counted once, without the mesh's boundary; units
  double hull_area = 0;       // of the convex hull; square units
  double box_area = 0;        // of the least-area rectangle around it; square units
  double longest_branch = 0;  // panels from the centroid of the tree to the farthest leaf, without the centroid
  double sheet_area = 0;      // of the smallest sheet with sides 1 : sqrt 2 that holds it; square units
  double weak_folds = 0;      // too short for what they carry (unfold/handy_folds.h)
  double needles = 0;         // panels that hang by their short side only
};

// Of a spanning tree of a connected mesh, laid flat. Folds under `shortest_fold`, in units, are weak. O(n log n).
NetFeatures net_features(const Mesh& mesh, const FoldForest& tree, double shortest_fold = 0);

// No net of a connected mesh is cut less than this: all interior edges but those of the longest spanning tree of the
// dual graph. Whether a net reaches it is another matter. O(n log n).
double least_cut_length(const Mesh& mesh);

struct OptimizeOptions {
  std::uint64_t seed = 1;  // same mesh, net and options: same result for every thread count, if allowed to finish
  NetFeatures weights{.cut_length = 1};  // w_i of the features, each taken relative to its value in the given net; >= 0
  long steps = -1;                       // branches tried by each lane; -1: 2000 a panel, but no more than 600,000
  int lanes = 2;                         // searches side by side, at least 1
  int starts = 24;  // nets grown afresh; the lanes set out from the best of these and the given one; at least 0
  double shortest_fold = 0;  // of what counts as weak, units, at least 0
  // Folds of the given net, by edge of the mesh, that are cut for printing; empty for none. They stay as they are,
  // hulls, boxes and sheets are summed over the pieces between them, and each piece goes on fitting `room`. Needs
  // starts = 0.
  std::vector<char> cuts = {};
  Vec2 room = Vec2::Zero();  // units
};
void check(const OptimizeOptions& options);  // throws InvalidOption naming field, value and range

// "cut-length", "hull-area", "page" or "hands": the weights for one wish. Throws InvalidOption.
NetFeatures weights_for(std::string_view wish);

struct OptimizeResult {
  Ending ending = Ending::Found;  // Found: the search took its course; otherwise the best net until then
  FoldForest forest;              // a net, by no feature sum worse than the given one
  NetFeatures before, after;
};

// `net` must be one net of the connected `mesh` without overlap (InvalidInput otherwise). O(1) in cut length and
// O(branch) in overlaps for a step; hull and box cost O(n) when a branch that touches the hull moves and may gain, and
// the longest branch O(n) always. Memory is linear.
OptimizeResult optimize_net(const Mesh& mesh, const FoldForest& net, const OptimizeOptions& options = {},
                            const Run& run = {});

// The same for a net that folds: no branch is hung where the motion is seen to collide, and what is returned has been
// looked at closely by the motion cost (MotionCost::look_closer) and found free, or is the given net. Nets grown afresh
// do not fold, so options.starts counts for nothing.
OptimizeResult optimize_foldable_net(const Mesh& mesh, const FoldForest& net,
                                     const std::function<std::unique_ptr<MotionCost>()>& new_cost,
                                     const OptimizeOptions& options = {}, const Run& run = {});

}  // namespace plico
