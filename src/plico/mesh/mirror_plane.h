// Left and right: the plane in which a shape is its own mirror image, however its surface is cut into faces.
#pragma once
#include <optional>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

struct MirrorPlane {
  Vec3 on = Vec3::Zero(), across = Vec3::UnitX();  // a point, and the unit normal

  double height(const Vec3& p) const { return across.dot(p - on); }
  Vec3 image(const Vec3& p) const { return p - 2 * height(p) * across; }
  Vec3 foot(const Vec3& p) const { return p - height(p) * across; }
};

// Unit vectors that may be across a shape about `middle`: the axes of space, then the principal axes of its surface.
// O(n).
std::vector<Vec3> candidates_across(const Mesh& mesh, const Vec3& middle);

// The image of every vertex lies on the surface, to `tolerance` of the diagonal. Planes through the centre of the
// surface across an axis of space or a principal axis are tried, in this order. O(n log n).
std::optional<MirrorPlane> mirror_plane(const Mesh& mesh, double tolerance = 5e-3);

// What lies above the plane, faces that cross it cut there, and whether each vertex lies on the plane, exactly;
// vertices close to the plane are moved onto it. None when a face lies in the plane, nothing above it, or the half is
// no mesh.
struct HalfMesh {
  PolygonSoup soup;  // triangles
  std::vector<char> on_plane;
};
std::optional<HalfMesh> upper_half(const Mesh& triangles, const MirrorPlane& plane);

// A half and its image, joined at the vertices on the plane.
PolygonSoup with_image(const HalfMesh& half, const MirrorPlane& plane);

}  // namespace plico
