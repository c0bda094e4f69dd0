// What must close for a sheet to stay whole: the loops around its real vertices and its holes.
#pragma once
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

// A walk around something inside the sheet that must end where it began: a vertex all of whose edges are creases, or a
// hole, around which the sheet must close in place as well as in direction.
struct RealVertex {
  int vertex = -1;                // of a hole: the lowest one on its border
  std::vector<int> hinges;        // counter-clockwise around it, indices as in make_linkage
  std::vector<Vec2> directions;   // of each, unit, away from the vertex or hole
  std::vector<Vec2> points = {};  // holes only: where each starts, from the first one, in diagonals of the sheet
  Vec2 place = Vec2::Zero();      // of the vertex, on the sheet

  bool is_hole() const { return !points.empty(); }
  int num_equations() const { return is_hole() ? 6 : 3; }
};

// Every real vertex, ascending, then every hole that creases reach; all other vertices are virtual. A part has one
// outer border; each further border is a hole, slits included. Throws as edge_sides does. O(edges log edges).
std::vector<RealVertex> real_vertices(const CreasePattern& sheet);

// The length of the diagonal of the sheet's bounding box, units.
double diagonal(const CreasePattern& sheet);

}  // namespace plico
