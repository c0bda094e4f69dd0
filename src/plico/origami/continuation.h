// From flat to the goal along the foldable configurations: the planner for patterns with one way to fold.
#pragma once
#include <string_view>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/motion/collision.h"
#include "plico/origami/projector.h"

namespace plico {

struct ContinuationOptions {
  int frames = 50;             // aimed at, at least 1; more where a frame must be halved
  double min_progress = 1e-4;  // of the way; a frame that must be shorter ends the plan
  double max_move = 0.5;       // radians a fold angle may turn in one frame; above 0
  ProjectOptions projection = {};
  CollisionOptions collision = {};
  bool check_collisions = true;
};

// Why a plan ended short of the goal.
enum class Obstacle {
  None,
  GoalOpen,   // the goal does not close: no rigid sheet has this form
  Locked,     // no foldable configuration close enough ahead
  WrongSide,  // the sheet would leave the mountain-valley assignment
  Collision
};
std::string_view name(Obstacle obstacle);  // "none", "goal-open", "locked", "wrong-side", "collision"

struct ContinuationResult {
  Ending ending = Ending::Exhausted;
  FoldingPath path;           // waypoints close to the projection's tolerance, the goal to 1e-9; `time` is progress
  double worst_residual = 0;  // of all waypoints, radians
  Obstacle obstacle = Obstacle::None;
  double progress = 0;  // of the way, reached
  int vertex = -1;      // GoalOpen, Locked: of the sheet, where the residual was largest
  int hinge = -1;       // WrongSide, and Locked when an angle would have to jump
  PanelPair panels;     // Collision
  double residual = 0;  // GoalOpen, Locked: the smallest that was reached there, radians
};

// Steps towards the goal and projects each frame to the closure of `sheet`; halves a step that does not close, moves
// too far, turns a crease against its goal or collides. Waypoints close and are free of collision; the motion between
// them is to be proven (verify/path.h). Deterministic. A path that ends early holds what was reached.
ContinuationResult continue_to_goal(const CreasePattern& sheet, const ContinuationOptions& options = {},
                                    const Run& run = {});

}  // namespace plico
