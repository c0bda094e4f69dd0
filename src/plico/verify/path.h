// Proof that a motion is free of collision at every moment, not only at samples.
//
// Panels are plates, thin or prisms as thick as the linkage says, shrunk by a clearance, as in every check of a motion;
// touching is allowed, penetration deeper than `touch` is not. Time is halved until, on an interval, each pair of
// plates is either
//   - apart: their swept boxes are disjoint, or a direction, seen from the last panel common to their chains, separates
//     them at both ends of the interval by more than both can stray from the chords of their corners in between;
//   - touching: the same up to `touch`, and then they may not turn up on the other side of each other; or
//   - in collision: at the middle of their chords they penetrate deeper than both can stray, plus `touch`.
// Every comparison leaves room for rounding (PanelMotion::rounding). It shares no code with planners and their checks.
// Thin panels at a common hinge are kept apart by the hinge while it turns by at most 180 degrees and neither reaches
// across its line; panels of different parts are never compared: each part folds by itself. Sheets with loops move as
// sheet_motion.h says. Their hinges open between waypoints by up to a bounded gap, so the hinge keeps its panels apart
// up to that gap, and touching is allowed up to it as well. The gap must stay below the clearance.
#pragma once
#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/verify/panel_motion.h"
#include "plico/verify/sheet_motion.h"

namespace plico {

struct PathProofOptions {
  double clearance = 0;      // how far every side of a panel moves inward, units; 0: 1e-3 of the mean side length
  double touch = 0;          // deepest penetration that still is a touch, units; 0: 1e-3 of the clearance; with loops
                             // at least their gap
  double closing = 1e-6;     // radians: a waypoint whose loops are farther open does not close; above 0
  double resolution = 1e-9;  // intervals shorter than this are not halved, in (0, 1]
  long max_looks = 0;        // at one plate or one pair of plates on an interval; then the proof ends; 0: no limit
};

enum class PathVerdict { Free, Collides, Undecided, NotClosed, BeyondLimits };
std::string_view name(PathVerdict verdict);  // "free", "collides", "undecided", "not closed", "beyond limits"

struct PathProof {
  PathVerdict verdict = PathVerdict::Undecided;
  // Collides: the panels are clear of each other (or the motion begins) at `from` and penetrate at `to`.
  // Undecided: neither could be shown on [from, to].
  // NotClosed: the waypoint at `from` = `to` does not close at loops.hinge, between the panels.
  // BeyondLimits: the hinge between the panels is turned farther there than the linkage allows.
  double from = 0, to = 0;
  int panel_a = -1, panel_b = -1;
  double depth = 0;          // of the penetration at `to`, units
  bool too_coarse = false;   // Undecided, for loops open between the waypoints at `from` and `to` by the clearance
  bool interrupted = false;  // the run was over, or all looks taken, before the proof was: Undecided, on [from, 1]
  double free_until = 0;     // the motion up to then is shown free, whatever comes later; 1 when Free
  long intervals = 0;        // of time, on which all panels or the undecided pairs were looked at
  long pair_intervals = 0;   // pairs of plates examined one by one on an interval
  double clearance = 0, touch = 0, rounding = 0;  // used, units
  LoopReport loops;                               // of sheets with loops
};

// The verdict is about exactly this motion: fold angles linear between waypoints, or with loops as in SheetMotion.
// Collides as soon as one collision is
// certain, not necessarily the first one in time.
PathProof prove_path(const Linkage& linkage, const FoldingPath& path, const PathProofOptions& options = {},
                     const Run& run = {});

// The same for any motion of the linkage's panels (crease patterns whose loops are closed on the way). The hinge rule
// of neighbours is then the caller's claim.
PathProof prove_motion(const Linkage& linkage, PanelMotion& motion, const PathProofOptions& options = {},
                       const Run& run = {});

}  // namespace plico
