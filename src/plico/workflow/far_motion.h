// The motion of a sheet that cannot reach its goal: as far as it goes, with whole panels or with panels cut by flat
// creases.
#pragma once
#include "plico/motion/collision.h"
#include "plico/workflow/plan_motion.h"

namespace plico {

// A motion with its proof, or none (no waypoints) when the sheet cannot leave flat.
struct FarMotion {
  Motion motion;
  double share = 0;                    // of the way to the goal (share_of_way), proven
  bool reached = false;                // the goal, proven
  bool timed_out = false;              // more time may lead farther
  std::optional<CreasePattern> sheet;  // that it folds, when panels were cut; its first edges are those of the given
  std::vector<double> bends;           // then: of each panel of the given sheet, radians at most, 0 stays flat
  std::vector<std::string> notes;      // how far, and why not farther
};

// The same run that must end when `share` of the time it has left is over; without a deadline the same run.
Run share_of_time(const Run& run, double share);

// The part of a planned motion that can be proven: waypoints are inserted until hinges open by little (refine_path),
// and what comes after the first moment that the proof refuses is left off. `clearance` in units.
// `met` (may be null) gets the panels that the proof could not tell apart. `open`: radians by which the loops of the
// path are open, on purpose; 0: they close.
Motion prove_as_far(const Linkage& linkage, const FoldingPath& planned, MotionMethod method, double clearance,
                    const Run& run = {}, std::vector<PanelPair>* met = nullptr, double open = 0);

// `begun` is a path that stops early; the sheet goes on from there (origami/approach.h). Cuts panels (origami/facets.h)
// of `sheet`, that the linkage was made from, as options.facets says: Auto when that brings the sheet farther than
// whole panels by at least a hundredth. Panels stay whole when it is null.
FarMotion go_as_far(const Linkage& linkage, const CreasePattern* sheet, const FoldingPath& begun,
                    const MotionOptions& options, const Run& run = {});

// From flat with whole panels that stretch or shrink a little: loops stay open at waypoints, such that no edge changes
// its length by more than options.deformation of it (verify/deformation.h) and no two places of one vertex are farther
// apart than by that share of the mean side. The proof is at deformed_clearance.
FarMotion go_deformed(const Linkage& linkage, const CreasePattern& sheet, const MotionOptions& options,
                      const Run& run = {});

}  // namespace plico
