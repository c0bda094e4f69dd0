// Towards a goal that may be out of reach, as far as the sheet goes.
#pragma once
#include <functional>

#include "plico/origami/continuation.h"

namespace plico {

struct ApproachOptions {
  int frames = 50;            // a fold angle turns by at most 180 degrees / frames from one waypoint to the next
  double facet_weight = 0.1;  // of a turn of a crease whose goal is 0, against those that are to fold; above 0
  double min_move = 1e-3;     // radians: a frame in which no crease turns farther is a standstill; above 0
  int max_waypoints = 1000;   // at least 1
  bool keep_sides = true;     // no crease turns against its goal; what would is held flat
  double tolerance = 1e-13;   // radians, of the worst residual of a waypoint; above 0
  double damping = 1e-9;      // of the projection: what opens the sheet by less than its root counts as closed; above 0
  bool check_collisions = true;
  CollisionOptions collision = {};
  std::function<bool(const Configuration&)> accepts = {};  // what else a waypoint must satisfy
  Configuration emphasis = {};  // of each crease, above 0, or empty for 1: its distance to the goal counts so much
  std::vector<PanelPair> watched = {};  // kept apart wherever they are near each other, also before they collide
};

// Descends from the end of `begun` (from flat when it has less than two waypoints) along the foldable configurations:
// every step goes along the part of the way to the goal that keeps all loops closed to first order, and panels that
// would collide apart (motion/contacts.h: they slide along each other), is projected to the closure, and must come
// nearer to the goal in the least squares of `facet_weight`. It ends at the goal (Found), where no step comes nearer
// (GoalOpen when the goal does not close, else Locked) or a hundred waypoints hardly do, where panels in contact leave
// no other way, or after max_waypoints (Obstacle::None, Exhausted). The path goes on from `begun`, its times are
// lengths of the way, 1 at the end; `progress` is share_of_way. Deterministic. O(waypoints) projections and collision
// checks.
ContinuationResult approach_goal(const Linkage& linkage, const FoldingPath& begun, const ApproachOptions& options = {},
                                 const Run& run = {});
inline ContinuationResult approach_goal(const CreasePattern& sheet, const FoldingPath& begun,
                                        const ApproachOptions& options = {}, const Run& run = {}) {
  return approach_goal(make_linkage(sheet), begun, options, run);
}

}  // namespace plico
