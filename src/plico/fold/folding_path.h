// A motion: a polyline of configurations, time 0 flat, time 1 folded. Between two waypoints every fold angle changes
// linearly; that is part of its meaning, because the proof of collision freedom is about exactly this motion.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

struct Waypoint {
  double time = 0;  // in [0, 1], strictly increasing along a path
  Configuration config;
};

struct FoldingPath {
  std::vector<Waypoint> waypoints;  // at least two: time 0 and time 1

  Configuration at(double time) const;  // clamped to [0, 1]. O(log waypoints + hinges)
};

// The first waypoint at which a hinge is beyond its limits by more than kLimitRounding, -1 for none. Between two
// waypoints within the limits all angles are.
int waypoint_beyond_limits(const Linkage& linkage, const FoldingPath& path);

// Throws InvalidInput "fold/limits" when there is one: who shows or writes a motion does not show what the material
// cannot do.
void require_within_limits(const Linkage& linkage, const FoldingPath& path);

// Straight from flat to goal: all creases arrive together.
FoldingPath linear_path(const Linkage& linkage);

// Every crease turns at the same angular speed and stops at its target: what a uniformly heated sheet does.
FoldingPath uniform_path(const Linkage& linkage);

}  // namespace plico
