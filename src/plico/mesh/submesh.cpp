#include "plico/mesh/submesh.h"

#include <numeric>

namespace plico {

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
  part.edge.resize(part.mesh.num_edges());
  for (FaceId f : part.mesh.faces()) {
    HalfedgeId whole = *mesh.halfedges(FaceId(part.face[f])).begin();
    for (HalfedgeId h : part.mesh.halfedges(f)) {
      part.edge[part.mesh.edge(h)] = mesh.edge(whole);
      whole = mesh.next(whole);
    }
  }
  return part;
}

}  // namespace plico
