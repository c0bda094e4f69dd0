// Convex polyhedra: hull of points, cut by planes, measures. The hull is decided exactly; what a plane cuts is rounded.
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// The points x with normal.x = offset; "below" is normal.x < offset. The normal has length 1.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;

  double height(const Vec3& p) const { return normal.dot(p) - offset; }  // signed distance, positive above
  Plane flipped() const { return {-normal, -offset}; }
};

// The closed set of points below the planes of all facets, and its boundary: every edge has two facets, which run along
// it in opposite directions. Without facets it is empty.
struct ConvexPolyhedron {
  static constexpr int kOwn = -1;

  struct Facet {
    std::vector<int> corners;  // counter-clockwise seen from outside
    Plane plane;               // outward
    int source = kOwn;         // the number given to clip() of the plane that made it
  };
  std::vector<Vec3> points;
  std::vector<Facet> facets;

  bool empty() const { return facets.empty(); }
};

// The hull of the points, in triangles; every point of the result is one of the input, no edge is reflex and no
// triangle degenerate, exactly. Which of several coplanar triangulations comes out depends on the order of the points.
// Empty when no four points span space. Quickhull (Barber et al. 1996) with exact decisions, O(n log n) expected.
ConvexPolyhedron convex_hull(std::span<const Vec3> points);

// The part below the plane, with the cut closed by a facet (or several, if rounding tears it) marked `source`. Closed
// by construction: only the sign of each height counts, and an edge that crosses gets one point. O(corners).
ConvexPolyhedron clip(const ConvexPolyhedron& body, const Plane& plane, int source);

ConvexPolyhedron intersection(ConvexPolyhedron a, const ConvexPolyhedron& b, int source);  // facets of b get `source`

double volume(const ConvexPolyhedron& body);
Vec3 centroid(const ConvexPolyhedron& body);  // of the volume; of the points when there is none
Eigen::AlignedBox3d bounding_box(std::span<const Vec3> points);
Vec3 vector_area(const ConvexPolyhedron& body, const ConvexPolyhedron::Facet& facet);  // normal times area

// Lowest and highest value of direction.x on the points.
std::pair<double, double> extent(std::span<const Vec3> points, const Vec3& direction);

// Volume of the union, each body less those before it, cut into convex pieces. O(pieces * facets).
double union_volume(std::span<const ConvexPolyhedron> bodies);

// A plane that has `a` below and `b` above, in the middle of the widest gap; none when they overlap by more than
// `tolerance`. By the separating axes of facets and of edges whose arcs on the Gauss sphere cross. O(n m).
std::optional<Plane> separating_plane(const ConvexPolyhedron& a, const ConvexPolyhedron& b, double tolerance);

// The sides of a plane on which a point lies, exactly: +1 above, -1 below, 0 on it. The plane is taken as its four
// doubles, whatever the length of its normal.
int side_of_plane(const Plane& plane, const Vec3& point);

}  // namespace plico
