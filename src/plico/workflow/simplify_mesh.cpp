#include "plico/workflow/simplify_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/mesh/check.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/self_intersections.h"

namespace plico {

SimplifiedMesh simplify_mesh(const Mesh& mesh, const SimplifyOptions& options) {
  check(options);
  SimplifiedMesh result;
  if (mesh.num_faces() <= options.faces) {
    result.mesh = mesh;
    result.faces_before = mesh.num_faces();
    result.notes.push_back(fmt::format("the mesh has {} faces already", mesh.num_faces()));
    return result;
  }
  const Mesh triangles(triangulated(mesh.soup()));
  result.faces_before = triangles.num_faces();
  PolygonSoup simple = simplified(triangles, options);
  const int before = static_cast<int>(self_intersections(triangles.soup()).size());
  result.crossings = std::max(0, static_cast<int>(self_intersections(simple).size()) - before);
  result.distance = vertex_distance(triangles.soup(), simple);
  result.mesh = Mesh(std::move(simple));
  if (result.mesh.num_faces() > options.faces)
    result.notes.push_back(fmt::format("{} faces are left: fewer would turn a face over, close a hole or join parts",
                                       result.mesh.num_faces()));
  if (result.crossings > 0)
    result.notes.push_back(fmt::format(
        "{} pairs of faces pass through each other, which did not before; ask for more faces", result.crossings));
  return result;
}

}  // namespace plico
