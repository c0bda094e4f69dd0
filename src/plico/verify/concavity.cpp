#include "plico/verify/concavity.h"

#include <algorithm>
#include <limits>
#include <set>

#include "plico/geom/convex3.h"

namespace plico {
namespace {

double concavity_of_part(const Mesh& mesh, const std::vector<FaceId>& faces) {
  std::set<int> corners;
  for (FaceId f : faces) corners.insert(mesh.corners(f).begin(), mesh.corners(f).end());
  std::vector<Vec3> points;
  for (int v : corners) points.push_back(mesh.point(VertexId(v)));
  const ConvexPolyhedron hull = convex_hull(points);
  if (hull.empty()) return 0;
  std::vector<double> depth(points.size(), std::numeric_limits<double>::infinity());
  for (const ConvexPolyhedron::Facet& facet : hull.facets) {
    const Vec3 direction = facet.plane.normal;
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : points) reach = std::max(reach, direction.dot(p));
    for (std::size_t i = 0; i < points.size(); ++i) depth[i] = std::min(depth[i], reach - direction.dot(points[i]));
  }
  return *std::max_element(depth.begin(), depth.end());
}

}  // namespace

double concavity_bound(const Mesh& mesh, const Segmentation& parts) {
  double deepest = 0;
  for (const std::vector<FaceId>& faces : faces_of_parts(parts))
    deepest = std::max(deepest, concavity_of_part(mesh, faces));
  return deepest;
}

}  // namespace plico
