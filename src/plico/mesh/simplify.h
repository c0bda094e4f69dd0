// Fewer triangles for the same shape. Source: M. Garland and P. Heckbert, Surface Simplification Using Quadric Error
// Metrics (1997).
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

struct SimplifyOptions {
  int faces = 300;  // asked for, at least 4; a closed triangle mesh has an even number of faces
  // Pull towards triangles of even size against the pull towards the shape, at least 0; dimensionless.
  double evenness = 0.03;
};
void check(const SimplifyOptions& options);  // throws InvalidOption

// Collapses edges of a closed triangle mesh, cheapest first, until `faces` are left, rounded down to an even number.
// The result has the same components and genus, no face turned over in a collapse and none that is much thinner than
// what it replaces; it may have more faces than asked for when nothing more can be collapsed. Ties by vertex number.
// Throws InvalidInput for a mesh with a boundary or with polygons. O(n log n).
PolygonSoup simplified(const Mesh& mesh, const SimplifyOptions& options = {});

}  // namespace plico
