#include "plico/verify/inflation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/self_intersections.h"

namespace plico {
namespace {

int hyperbolic_vertices(const Mesh& mesh) {
  int count = 0;
  for (VertexId v : mesh.vertices()) count += is_hyperbolic(mesh, v);
  return count;
}

void find_turned_face(const Mesh& before, const Mesh& after, std::vector<std::string>& defects) {
  for (FaceId f : before.faces())
    if (!(normal(before, f).dot(normal(after, f)) > 0)) {
      defects.push_back(fmt::format("{} turned over", describe_face(after.soup(), f)));
      return;
    }
}

void find_new_meeting(const Mesh& before, const Mesh& after, std::vector<std::string>& defects) {
  const auto old = self_intersections(before.soup());
  for (const auto& pair : self_intersections(after.soup()))
    if (!std::binary_search(old.begin(), old.end(), pair)) {
      defects.push_back(fmt::format("faces {} and {} meet, and did not before", pair.first, pair.second));
      return;
    }
}

void find_moved_vertex(const Mesh& before, const Mesh& after, const std::vector<FaceId>& keep,
                       std::vector<std::string>& defects) {
  for (FaceId f : keep)
    for (int v : before.corners(f))
      if (before.point(VertexId(v)) != after.point(VertexId(v))) {
        defects.push_back(fmt::format("vertex {} of face {}, which is kept, moved", v, int(f)));
        return;
      }
}

void find_moved_pin(const Mesh& before, const Mesh& after, const std::vector<VertexId>& keep,
                    std::vector<std::string>& defects) {
  for (VertexId v : keep)
    if (before.point(v) != after.point(v)) {
      defects.push_back(fmt::format("vertex {}, which is kept, moved", int(v)));
      return;
    }
}

}  // namespace

InflationVerdict verify_inflation(const Mesh& before, const PolygonSoup& soup, const std::vector<FaceId>& keep,
                                  double max_growth, const std::vector<VertexId>& keep_vertices) {
  InflationVerdict verdict;
  verdict.hyperbolic_before = hyperbolic_vertices(before);
  if (soup.corners != before.soup().corners || soup.offsets != before.soup().offsets ||
      soup.num_points() != before.num_vertices()) {
    verdict.defects.emplace_back("the faces are not those of the mesh");
    return verdict;
  }
  if (!std::all_of(soup.points.begin(), soup.points.end(), [](const Vec3& p) { return p.allFinite(); })) {
    verdict.defects.emplace_back("a coordinate is not finite");
    return verdict;
  }
  const Mesh after(soup);
  verdict.hyperbolic = hyperbolic_vertices(after);
  verdict.growth = volume(after) / volume(before) - 1;
  find_turned_face(before, after, verdict.defects);
  find_new_meeting(before, after, verdict.defects);
  find_moved_vertex(before, after, keep, verdict.defects);
  find_moved_pin(before, after, keep_vertices, verdict.defects);
  if (!(std::abs(verdict.growth) <= max_growth + 1e-9))
    verdict.defects.push_back(
        fmt::format("the volume changed by {:.6g}, allowed is {:.6g}", verdict.growth, max_growth));
  return verdict;
}

}  // namespace plico
