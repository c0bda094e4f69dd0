// The surface where a smooth body ends, as triangles.
#pragma once
#include "plico/mesh/soup.h"
#include "plico/shapes/smooth_body.h"

namespace plico {

// Marching tetrahedra over cubes of side `spacing`, each cut into six (Freudenthal's triangulation), so that the
// surface is always closed and manifold; triangles face outward, and are not well shaped: simplify them. Details
// smaller than `spacing` are lost. O(box volume / spacing^3) space; most of that space is passed over in blocks.
PolygonSoup isosurface(const SmoothBody& body, double spacing);

}  // namespace plico
