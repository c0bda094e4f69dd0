// Neighbouring faces that lie in one plane as one polygon: what one would draw by hand.
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

struct FlatRegions {
  PolygonSoup soup;         // faces in the order of the first face of each region; unused vertices are dropped
  std::vector<int> region;  // of each face of the mesh: its face in `soup`
  int num_merged = 0;       // faces of `soup` that were several
};

// Faces are one region when every corner of theirs lies within `planarity` of the region's size of the plane of its
// largest face. A region with a hole, or one that touches itself in a vertex, keeps its faces. A vertex between two
// regions is dropped where both run straight through it, to the same tolerance. The shape is the same, so a net of the
// result folds to it. O(n log n).
FlatRegions flat_regions(const Mesh& mesh, double planarity = 1e-11);

// The mesh of its flat regions; the mesh itself where nothing joins, or what joins is no mesh of flat polygons.
Mesh with_flat_regions_whole(Mesh mesh);

}  // namespace plico
