#include "plico/segment/hull_depth.h"

#include <algorithm>
#include <limits>

#include "plico/geom/convex3.h"

namespace plico {
namespace {

std::vector<int> vertices_of(const Mesh& mesh, const std::vector<int>& faces) {
  std::vector<int> vertices;
  for (int f : faces) {
    const std::span<const int> corners = mesh.corners(FaceId(f));
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Planes of the hull side by side in memory: they are run through for every vertex.
std::vector<Plane> hull_planes(const Mesh& mesh, const std::vector<int>& vertices) {
  std::vector<Vec3> points;
  for (int v : vertices) points.push_back(mesh.point(VertexId(v)));
  std::vector<Plane> planes;
  for (const ConvexPolyhedron::Facet& facet : convex_hull(points).facets) planes.push_back(facet.plane);
  return planes;
}

double depth_below(const std::vector<Plane>& planes, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes) least = std::min(least, -plane.height(point));
  return planes.empty() ? 0 : std::max(least, 0.0);
}

}  // namespace

double PatchVertices::deepest() const { return depth.empty() ? 0 : *std::max_element(depth.begin(), depth.end()); }

int PatchVertices::at(int mesh_vertex) const {
  return static_cast<int>(std::lower_bound(vertex.begin(), vertex.end(), mesh_vertex) - vertex.begin());
}

PatchVertices hull_depths(const Mesh& mesh, const std::vector<int>& faces) {
  PatchVertices patch{vertices_of(mesh, faces), {}};
  const std::vector<Plane> planes = hull_planes(mesh, patch.vertex);
  for (int v : patch.vertex) patch.depth.push_back(depth_below(planes, mesh.point(VertexId(v))));
  return patch;
}

std::optional<double> depth_within(const Mesh& mesh, const std::vector<int>& faces, double bound) {
  const std::vector<int> vertices = vertices_of(mesh, faces);
  const std::vector<Plane> planes = hull_planes(mesh, vertices);
  double deepest = 0;
  for (int v : vertices) {
    deepest = std::max(deepest, depth_below(planes, mesh.point(VertexId(v))));
    if (deepest > bound) return std::nullopt;
  }
  return deepest;
}

}  // namespace plico
