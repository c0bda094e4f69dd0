// Where two shells touch along the plane between them.
#pragma once
#include <vector>

#include "plico/geom/convex3.h"

namespace plico {

// The convex polygon in which two bodies on both sides of a plane touch, counter-clockwise seen from above it; points
// within `tolerance` of the plane lie on it. Empty when they meet in less than an area. O(n log n + n m).
std::vector<Vec3> contact_polygon(const ConvexPolyhedron& below, const ConvexPolyhedron& above, const Plane& plane,
                                  double tolerance);

}  // namespace plico
