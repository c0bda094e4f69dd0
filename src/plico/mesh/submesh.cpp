#include "plico/mesh/submesh.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace plico {
namespace {

// The edge of the whole mesh for every edge of the part.
void find_edges(const Mesh& mesh, Submesh& part) {
  part.edge.resize(part.mesh.num_edges());
  for (FaceId f : part.mesh.faces()) {
    HalfedgeId whole = *mesh.halfedges(FaceId(part.face[f])).begin();
    for (HalfedgeId h : part.mesh.halfedges(f)) {
      part.edge[part.mesh.edge(h)] = mesh.edge(whole);
      whole = mesh.next(whole);
    }
  }
}

// The halfedge at which a fan of the part around from(h) begins, turning clockwise from h; in a closed fan the one with
// the smallest number.
HalfedgeId start_of_fan(const Mesh& mesh, const std::unordered_set<int>& inside, HalfedgeId h) {
  HalfedgeId at = h, smallest = h;
  while (true) {
    const HalfedgeId twin = mesh.twin(at);
    if (!twin.valid() || !inside.contains(mesh.face(twin))) return at;
    at = mesh.next(twin);
    if (at == h) return smallest;
    smallest = std::min(smallest, at);
  }
}

}  // namespace

Submesh component(const Mesh& mesh, const Components& components, int which) {
  Submesh part;
  if (components.count == 1) {
    part.mesh = mesh;
    part.face.resize(mesh.num_faces());
    part.edge.resize(mesh.num_edges());
    std::iota(part.face.begin(), part.face.end(), 0);
    std::iota(part.edge.begin(), part.edge.end(), 0);
    return part;
  }
  PolygonSoup soup;
  soup.points = mesh.soup().points;
  for (FaceId f : mesh.faces()) {
    if (components.of_face[f] != which) continue;
    part.face.push_back(f);
    soup.add_face(mesh.corners(f));
  }
  part.mesh = Mesh(std::move(soup));
  find_edges(mesh, part);
  return part;
}

Submesh submesh(const Mesh& mesh, std::vector<FaceId> faces) {
  std::sort(faces.begin(), faces.end());
  const std::unordered_set<int> inside(faces.begin(), faces.end());
  Submesh part;
  PolygonSoup soup;
  std::unordered_map<int, int> vertex_of_fan;
  for (FaceId f : faces) {
    part.face.push_back(f);
    std::vector<int> corners;
    for (HalfedgeId h : mesh.halfedges(f)) {
      const auto [at, is_new] = vertex_of_fan.try_emplace(start_of_fan(mesh, inside, h), soup.num_points());
      if (is_new) soup.points.push_back(mesh.point(mesh.from(h)));
      corners.push_back(at->second);
    }
    soup.add_face(corners);
  }
  part.mesh = Mesh(std::move(soup));
  find_edges(mesh, part);
  return part;
}

}  // namespace plico
