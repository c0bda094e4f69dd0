// A polygon surface in space with its adjacency: the shape every algorithm starts from.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "plico/base/ids.h"
#include "plico/base/vec.h"
#include "plico/mesh/soup.h"

namespace plico {

// An oriented 2-manifold, with or without boundary, of any genus and any number of components; faces are planar
// polygons, counter-clockwise seen from outside. Immutable.
//
// Halfedge h runs along one side of a face: from(h) -> to(h), with face(h) on its left. Halfedges of a face are
// numbered consecutively, in the order of its corners. twin(h) runs the other way in the neighbouring face and is
// invalid on the boundary. Every edge has one halfedge or two; halfedge(e) is the one with the smaller number.
// Edges are numbered by their smaller halfedge. All lookups are O(1).
class Mesh {
 public:
  Mesh() = default;

  // Builds the adjacency. Throws InvalidInput when there is no face, a coordinate is not finite, an index is out of
  // range, a face has under 3 corners or repeats a vertex, an edge has more than two faces, two neighbours run along
  // their edge in the same direction, or the faces around a vertex make more than one fan. mesh/check.h lists all such
  // problems at once. O(n) expected.
  explicit Mesh(PolygonSoup soup);

  int num_vertices() const { return soup_.num_points(); }
  int num_edges() const { return static_cast<int>(edge_halfedge_.size()); }
  int num_faces() const { return soup_.num_faces(); }
  int num_halfedges() const { return static_cast<int>(soup_.corners.size()); }
  IdRange<VertexId> vertices() const { return IdRange<VertexId>(num_vertices()); }
  IdRange<EdgeId> edges() const { return IdRange<EdgeId>(num_edges()); }
  IdRange<FaceId> faces() const { return IdRange<FaceId>(num_faces()); }

  const PolygonSoup& soup() const { return soup_; }
  const Vec3& point(VertexId v) const { return soup_.points[v]; }
  int degree(FaceId f) const { return soup_.offsets[f + 1] - soup_.offsets[f]; }
  IdRange<HalfedgeId> halfedges(FaceId f) const { return {soup_.offsets[f], soup_.offsets[f + 1]}; }
  std::span<const int> corners(FaceId f) const { return soup_.face(f); }  // vertex indices, counter-clockwise

  VertexId from(HalfedgeId h) const { return VertexId(soup_.corners[h]); }
  VertexId to(HalfedgeId h) const { return from(next(h)); }
  FaceId face(HalfedgeId h) const { return FaceId(face_[h]); }
  EdgeId edge(HalfedgeId h) const { return EdgeId(edge_[h]); }
  HalfedgeId twin(HalfedgeId h) const { return HalfedgeId(twin_[h]); }
  HalfedgeId next(HalfedgeId h) const {
    const FaceId f = face(h);
    return HalfedgeId(h + 1 == soup_.offsets[f + 1] ? soup_.offsets[f] : h + 1);
  }
  HalfedgeId prev(HalfedgeId h) const {
    const FaceId f = face(h);
    return HalfedgeId(h == soup_.offsets[f] ? soup_.offsets[f + 1] - 1 : h - 1);
  }
  HalfedgeId halfedge(EdgeId e) const { return HalfedgeId(edge_halfedge_[e]); }
  bool is_boundary(EdgeId e) const { return !twin(halfedge(e)).valid(); }
  // A halfedge that leaves v; on the boundary the one whose prev() side is open, so that turning by twin(prev(h))
  // visits the whole fan. Invalid for a vertex without faces.
  HalfedgeId halfedge(VertexId v) const { return HalfedgeId(vertex_halfedge_[v]); }

 private:
  void find_twins();
  void number_edges();
  void find_fans();

  PolygonSoup soup_;
  std::vector<int> face_, twin_, edge_;  // one per halfedge
  std::vector<int> edge_halfedge_, vertex_halfedge_;
};

// "face 12 (3 7 9, near 0.1 2 -3)": how an element is named in messages.
std::string describe_face(const PolygonSoup& soup, int face);
std::string describe_edge(const PolygonSoup& soup, int a, int b);
std::string describe_vertex(const PolygonSoup& soup, int vertex);

}  // namespace plico
