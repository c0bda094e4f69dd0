#include "plico/workflow/simplify_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "plico/base/error.h"
#include "plico/mesh/check.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/self_intersections.h"

namespace plico {
namespace {

int crossings_of(const PolygonSoup& soup) { return static_cast<int>(self_intersections(soup).size()); }

// Equal halves, if there is a plane for them and both are in order.
std::optional<PolygonSoup> alike(const Mesh& triangles, const SimplifyOptions& options) {
  const std::optional<MirrorPlane> plane = mirror_plane(triangles);
  if (!plane) return {};
  try {
    std::optional<PolygonSoup> soup = simplified_alike(triangles, *plane, options);
    if (!soup || soup->num_faces() > options.faces || is_closed(Mesh(*soup)) != is_closed(triangles)) return {};
    return soup;
  } catch (const InvalidInput&) {  // a surface that touches itself at the plane
    return {};
  }
}

}  // namespace

SimplifiedMesh simplify_mesh(const Mesh& mesh, const SimplifyOptions& options, Halves wish) {
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
  const int before = crossings_of(triangles.soup());
  std::optional<PolygonSoup> halves = wish == Halves::Free ? std::nullopt : alike(triangles, options);
  if (halves && wish == Halves::Auto && crossings_of(*halves) > before) halves.reset();
  result.symmetric = halves.has_value();
  PolygonSoup simple = halves ? std::move(*halves) : simplified(triangles, options);
  if (wish == Halves::Alike && !result.symmetric) result.notes.emplace_back("the shape is not symmetric");
  result.crossings = std::max(0, crossings_of(simple) - before);
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
