// From a sheet with loops to a proven motion, or to what stands in its way.
#pragma once
#include "plico/workflow/plan_motion.h"

namespace plico {

// What plan() does (workflow/plan_motion.h) for a linkage with loops.
// Continuation from flat to the goal (origami/continuation.h); then waypoints are inserted, each projected to the
// closure, until no hinge opens between two of them by more than a fifth of the clearance; then the proof
// (verify/path.h).
//   - A goal that almost closes, as one rounded to a few digits does, is first moved to the nearest that does: at most
//     kMostGoalMove. Nothing is moved farther.
//   - A motion that would exceed the limit of a crease ends before that.
//   - A plan that ends early goes on as far as the sheet does (far_motion.h). The motion's times are scaled to [0, 1]
//   and the ending is Exhausted; `notes` say why: "not rigid: ...",
//     "left the branch ...", "collides ...", "limited ...".
//   - When the straight way is blocked and the sheet has at most 64 creases, Auto looks for another one with MD-FROG
//     (origami/md_frog.h), which the proof judges path by path. Frog and MdFrog are the dissertation's planners alone.
//   - `options.grouped` plans with one unknown a crease group and the loops of essential vertices; the path is proven
//     with all of them. `options.through` are states to pass, which only MD-FROG does.
// Deterministic. Throws InvalidOption for a method that is for trees or does not do what the options ask for,
// InvalidInput when sizes differ or a state to pass does not close.
MotionOutcome plan_loops(const Linkage& linkage, const MotionOptions& options = {}, const Run& run = {});

// plan() of the linkage of a sheet. Beside it, panels are cut by flat creases, which makes another sheet, when
// options.facets says so and whole panels do not get there.
MotionOutcome plan_origami(const CreasePattern& sheet, const MotionOptions& options = {}, const Run& run = {});

// The motion of a small sheet carried to a large one that continues its pattern (origami/reuse.h), refined and proven
// at full size. Of the options the clearance and the seed count. Throws InvalidInput as reuse_path does.
MotionOutcome reuse_motion(const Linkage& small, const FoldingPath& path, const Linkage& large,
                           const MotionOptions& options = {}, const Run& run = {});

inline constexpr double kMostGoalMove = radians(0.5);

// The path with waypoints inserted, each closed, until hinges open between two by at most `gap` units, if they can be
// found near the straight line between their neighbours and within the limits of the hinges. Times of the given
// waypoints stay. `closed`: radians that loops may be open by, in paths that were planned so. O(waypoints * creases).
FoldingPath refine_path(const Linkage& linkage, const FoldingPath& path, double gap, const Run& run = {},
                        double closed = 1e-9);

}  // namespace plico
