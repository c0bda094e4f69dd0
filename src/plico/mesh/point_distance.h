// How far points are from a surface.
#pragma once
#include "plico/geom/box_tree.h"
#include "plico/mesh/soup.h"

namespace plico {

// Of points from the triangles of a soup, which must outlive it; polygons are not taken. O(log n) a point for points
// close to the surface.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const PolygonSoup& triangles);
  double operator()(const Vec3& p) const;

 private:
  const PolygonSoup& soup_;
  BoxTree tree_;
};

}  // namespace plico
