// The two steps of remesh(): edges that shrink to a vertex, vertices that move.
#pragma once
#include <span>
#include <vector>

#include "plico/base/run.h"
#include "plico/convex/shell_surface.h"

namespace plico {

// What may still be added to a shell's volume, and what was done.
struct RemeshBudget {
  double volume = 0;  // left
  int solves = 0;
};

// Shrinks edges, the one that adds the least volume first, until there are no more than `faces` triangles, the budget
// is spent or no edge can. With `only_fatter`, only edges whose loss makes the surface fatter. Returns whether there
// are no more triangles than that.
bool shrink_edges(ShellSurface& surface, int faces, bool only_fatter, RemeshBudget& budget, const Run& run);

// Moves every vertex once, where that makes the surface fatter; `inside` are the points it must hold. Returns whether
// anything moved.
bool fatten_once(ShellSurface& surface, std::span<const Vec3> inside, RemeshBudget& budget);

// Fatness of triangles, weighted by area: sums that can be added and taken away.
struct FatSum {
  double fat = 0, area = 0;  // twice the areas

  void add(const Vec3& a, const Vec3& b, const Vec3& c);
  double share() const { return area > 0 ? fat / area : 0; }
  FatSum operator+(const FatSum& other) const { return {fat + other.fat, area + other.area}; }
  FatSum operator-(const FatSum& other) const { return {fat - other.fat, area - other.area}; }
};
FatSum fat_sum(const ShellSurface& surface);
FatSum fat_sum(const ShellSurface& surface, const std::vector<int>& triangles);
FatSum fan_sum(const ShellSurface& surface, const ShellSurface::Patch& patch, const Vec3& tip);  // over the loop

}  // namespace plico
