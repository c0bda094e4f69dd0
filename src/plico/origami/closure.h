// How far a configuration is from closing up around the real vertices and the holes of a sheet.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

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

// Throws InvalidInput "fold/thick-loops" or "fold/loops" when the loops of a linkage are not those of a thin sheet,
// which are the only ones that closure() knows: thick panels do not turn about the points of a plane.
void require_closable(const Linkage& linkage);

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
