// Fewer triangles for the same shape. Source: M. Garland and P. Heckbert, Surface Simplification Using Quadric Error
// Metrics (1997).
#pragma once
#include <optional>

#include "plico/mesh/mesh.h"
#include "plico/mesh/mirror_plane.h"

namespace plico {

struct SimplifyOptions {
  int faces = 300;  // asked for, at least 4; a closed triangle mesh has an even number of faces
  // Pull towards triangles of even size against the pull towards the shape, at least 0; dimensionless.
  double evenness = 0.03;
  bool keep_sharp = false;  // vertices on edges sharper than 20 degrees do not slide while triangles are evened out
};
void check(const SimplifyOptions& options);  // throws InvalidOption

// Collapses edges of a triangle mesh, cheapest first, until `faces` are left, rounded down to an even number when the
// mesh is closed. The result has the same components, genus and number of boundary loops, no face turned over in a
// collapse and none that is much thinner than what it replaces; it may have more faces than asked for when nothing more
// can be collapsed. Boundaries are held by planes through their edges. Ties by vertex number. It may cross itself where
// the shape was thin. Throws InvalidInput for polygons (triangulated() cuts them). O(n log n).
PolygonSoup simplified(const Mesh& mesh, const SimplifyOptions& options = {});

// One half is simplified, and comes with its image: left and right are equal, triangle by triangle. Vertices on the
// plane stay on it. None when the mesh cannot be halved; throws InvalidInput when a half is no mesh.
std::optional<PolygonSoup> simplified_alike(const Mesh& mesh, const MirrorPlane& plane,
                                            const SimplifyOptions& options = {});

// The same surface with every polygon cut into triangles.
PolygonSoup triangulated(const PolygonSoup& soup);

// The greatest distance of a vertex of one surface from the other, both ways: what a simplification strays, at least.
// O(n log n) for surfaces close to each other.
double vertex_distance(const PolygonSoup& a, const PolygonSoup& b);

}  // namespace plico
