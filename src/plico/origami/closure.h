// How far a configuration is from closing up around the real vertices, and the nearest one that closes.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

// A vertex inside the sheet, all of whose edges are creases.
struct RealVertex {
  int vertex = -1;
  std::vector<int> hinges;       // counter-clockwise around it, indices as in make_linkage
  std::vector<Vec2> directions;  // of each, unit, away from the vertex
};

// Every real vertex, ascending; all other vertices are virtual. Sheets with holes need more than these loops.
// O(edges log edges).
std::vector<RealVertex> real_vertices(const CreasePattern& sheet);

struct Closure {
  std::vector<double> residual;  // one per real vertex: angle by which the walk around it fails to close, in [0, pi]
  double worst = 0;              // largest residual; 0 without real vertices
  int worst_vertex = -1;         // of the sheet
};

// Eq. 2.1 read as R2.
//   - The flat state closes.
//   - Turning the sheet over (every fold angle negated) changes no residual.
// `config` has one fold angle per hinge. O(creases).
Closure closure(const std::vector<RealVertex>& vertices, const Configuration& config);

struct ProjectOptions {
  double tolerance = 1e-13;  // radians, of the worst residual; above 0
  double max_step = 0.3;     // radians a fold angle may move in one step; above 0
  double damping = 1e-9;     // added to the diagonal of J^T J; above 0
  int max_steps = 60;
};

struct Projection {
  Configuration config;  // the best found
  Closure closure;       // of it
  int steps = 0;
  bool closed = false;  // the tolerance was reached
};

// A foldable configuration near `start`, by damped Gauss-Newton: three rows a real vertex, the column of a crease is
// its direction turned by the walk so far. A step that makes the residual grow is halved. One symbolic factorization a
// call. The flat state is a branch point: what lies near it is found, but on no particular branch.
Projection project(const std::vector<RealVertex>& vertices, const Configuration& start,
                   const ProjectOptions& options = {});

}  // namespace plico
