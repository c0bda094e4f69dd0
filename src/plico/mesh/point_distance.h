// How far points are from a surface.
#pragma once
#include <array>

#include "plico/geom/box_tree.h"
#include "plico/mesh/soup.h"

namespace plico {

// Of the point of a triangle that is nearest to p, how much each corner counts: at least 0, together 1. Source: C.
// Ericson, Real-Time Collision Detection (2005), 5.1.5.
Vec3 nearest_weights(const std::array<Vec3, 3>& corners, const Vec3& p);

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
