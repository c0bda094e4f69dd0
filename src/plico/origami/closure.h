// How far a configuration is from closing up around the real vertices and the holes of a sheet.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

// A walk around something inside the sheet that must end where it began: a vertex all of whose edges are creases, or a
// hole, around which the sheet must close in place as well as in direction.
struct RealVertex {
  int vertex = -1;                // of a hole: the lowest one on its border
  std::vector<int> hinges;        // counter-clockwise around it, indices as in make_linkage
  std::vector<Vec2> directions;   // of each, unit, away from the vertex or hole
  std::vector<Vec2> points = {};  // holes only: where each starts, from the first one, in diagonals of the sheet

  bool is_hole() const { return !points.empty(); }
  int num_equations() const { return is_hole() ? 6 : 3; }
};

// Every real vertex, ascending, then every hole that creases reach; all other vertices are virtual. A part has one
// outer border; each further border is a hole, slits included. Throws as edge_sides does. O(edges log edges).
std::vector<RealVertex> real_vertices(const CreasePattern& sheet);

// The length of the diagonal of the sheet's bounding box, units.
double diagonal(const CreasePattern& sheet);

struct Closure {
  // One per real vertex: angle by which the walk around it fails to close, in [0, pi]. Of a hole: the norm of that and
  // of the gap in diagonals of the sheet.
  std::vector<double> residual;
  double worst = 0;       // largest residual; 0 without real vertices
  int worst_vertex = -1;  // of the sheet
};

// Eq. 2.1 read as R2.
//   - The flat state closes.
//   - Turning the sheet over (every fold angle negated) changes no residual.
// `config` has one fold angle per hinge. O(creases). Throws InvalidInput when it has fewer than the walks need.
Closure closure(const std::vector<RealVertex>& vertices, const Configuration& config);

// What a configuration that does not quite close does to the paper.
struct Tear {
  double gap = 0;          // largest distance between the images of one vertex, in diagonals of the sheet
  int vertex = -1;         // where; -1 when nothing tears
  double deformation = 0;  // largest relative change of an edge when each vertex is at the mean of its images (R2)
  int edge = -1;           // where; -1 when no length changes
};

// The images of a vertex are those under the folding maps of its panels. `linkage` is that of `sheet`. O(corners^2) in
// the panels around one vertex, otherwise linear.
Tear tear(const CreasePattern& sheet, const Linkage& linkage, const Configuration& config);

}  // namespace plico
