// Path reuse: a motion found on a small pattern folds every larger tessellation of it. Source: [Xi17] 3.3.2.
#pragma once
#include "plico/base/run.h"
#include "plico/motion/collision.h"
#include "plico/origami/crease_groups.h"

namespace plico {

// The motion of `small` carried to `large`: a crease moves as the group of `small` that has its place around a vertex
// does, to its own side; creases that stay flat stay so. Throws InvalidInput when a crease of `large` has a place that
// `small` does not have, with the crease, or when `small` itself does not move in groups (1e-6 rad).
FoldingPath reuse_path(const Linkage& small, const FoldingPath& path, const Linkage& large);
inline FoldingPath reuse_path(const CreasePattern& small, const FoldingPath& path, const CreasePattern& large) {
  return reuse_path(make_linkage(small), path, make_linkage(large));
}

// What a full look at every waypoint of a path finds: nothing is taken from the pattern that it came from.
struct WaypointCheck {
  Ending ending = Ending::Found;  // Found: all were looked at
  double worst_residual = 0;      // of all real vertices at all waypoints, radians
  int vertex = -1;                // where, of the sheet
  int waypoint = -1;              // the first that collides, or -1
  PanelPair panels;               // there
  bool valid(double tolerance = 1e-9) const {
    return ending == Ending::Found && worst_residual <= tolerance && waypoint < 0;
  }
};

// All real vertices and all pairs of panels. One thread a waypoint.
WaypointCheck check_waypoints(const Linkage& linkage, const FoldingPath& path, const CollisionOptions& options = {},
                              const Run& run = {});
inline WaypointCheck check_waypoints(const CreasePattern& sheet, const FoldingPath& path,
                                     const CollisionOptions& options = {}, const Run& run = {}) {
  return check_waypoints(make_linkage(sheet), path, options, run);
}

}  // namespace plico
