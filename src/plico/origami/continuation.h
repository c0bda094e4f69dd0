// From flat to the goal along the foldable configurations: the planner for patterns with one way to fold.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/motion/collision.h"
#include "plico/origami/projector.h"

namespace plico {

struct ContinuationOptions {
  int frames = 50;             // aimed at, at least 1; more where a frame must be halved
  double first_step = 0.01;    // of the way: the step that leaves the flat state, in (0, 1]
  double min_progress = 1e-4;  // of the way; a frame that must be shorter ends the plan
  double max_move = 0.5;       // radians a fold angle may turn in one frame; above 0
  double goal_slack = 1e-2;    // radians a fold angle of the goal may turn to make the goal close; at least 0

  // The group of each hinge, 0 ... k - 1, or empty for every crease by itself: creases of one group, whose goals must
  // be of one size, turn by one angle, each to its side.
  std::vector<int> groups = {};
  // The real vertices whose loops are closed, as Linkage::loops lists them, or empty for all: what suffices when
  // creases move in groups (crease_groups.h). The goal must close at all of them; the others are the caller's to check.
  std::vector<int> essential = {};
  bool unfold_too = true;  // when the way from flat fails, try the way back from the goal
  bool check_collisions = true;
  double tolerance = 1e-13;  // radians: residual of a waypoint that closes; above 0
  CollisionOptions collision = {};
};

// Why a plan ended short of the goal.
enum class Obstacle {
  None,
  GoalOpen,   // the goal does not close: no rigid sheet has this form
  Locked,     // no foldable configuration close enough ahead
  WrongSide,  // the sheet would leave the branch of the mountain-valley assignment
  Collision
};
std::string_view name(Obstacle obstacle);  // "none", "goal-open", "locked", "wrong-side", "collision"

struct ContinuationResult {
  Ending ending = Ending::Exhausted;
  FoldingPath path;           // waypoints close to the projection's tolerance, the goal to 1e-9; `time` is progress
  double worst_residual = 0;  // of all waypoints, radians
  int steps = 0;              // of Gauss-Newton, all in all
  Obstacle obstacle = Obstacle::None;
  double progress = 0;    // of the way, reached
  bool unfolded = false;  // the path was found from the goal backwards
  int vertex = -1;        // GoalOpen, Locked: where the way to the goal opens the sheet most; WrongSide: at the crease
  int hinge = -1;         // WrongSide, and Locked when an angle would have to jump
  PanelPair panels;       // Collision
  double residual = 0;    // GoalOpen: of the goal at `vertex`; Locked: of one frame straight on; radians
  int frame() const { return static_cast<int>(path.waypoints.size()); }  // the one that failed, flat is 0
};

// One sentence for people: "left the branch at 42 % of the way: crease 12 (vertices 3-9, near 1 0.5) would turn against
// its goal"; empty without obstacle. `linkage` is the one that was to fold.
std::string describe(const Linkage& linkage, const ContinuationResult& result);

// Steps towards the goal, corrects each step by what the last one was off, and projects to the closure;
// halves a step that does not close, moves too far, turns a crease against its goal or collides. Flat is left with
// steps of several sizes and in two directions (the goal, and the tangents of its half angles) until every crease turns
// to its side. Waypoints close and are free of collision; the motion between them is to be proven (verify/path.h).
// Goals beyond the limits of a hinge are clamped, the clamped goal is projected within them, and every waypoint keeps
// them. Deterministic. A path that ends early holds what was reached.
ContinuationResult continue_to_goal(const Linkage& linkage, const ContinuationOptions& options = {},
                                    const Run& run = {});
inline ContinuationResult continue_to_goal(const CreasePattern& sheet, const ContinuationOptions& options = {},
                                           const Run& run = {}) {
  return continue_to_goal(make_linkage(sheet), options, run);
}

}  // namespace plico
