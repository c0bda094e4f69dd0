#include "plico/mesh/measures.h"

#include "plico/base/libm.h"

namespace plico {
namespace {

// Twice the vector area: Newell's sum, taken about the first corner to keep digits far from the origin.
Vec3 twice_vector_area(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.corners(face);
  const Vec3& origin = mesh.point(VertexId(corners[0]));
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec3 a = mesh.point(VertexId(corners[i - 1])) - origin, b = mesh.point(VertexId(corners[i])) - origin;
    sum += a.cross(b);
  }
  return sum;
}

}  // namespace

Vec3 normal(const Mesh& mesh, FaceId face) {
  const Vec3 n = twice_vector_area(mesh, face);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double area(const Mesh& mesh, FaceId face) { return twice_vector_area(mesh, face).norm() / 2; }

double length(const Mesh& mesh, EdgeId edge) {
  const HalfedgeId h = mesh.halfedge(edge);
  return (mesh.point(mesh.to(h)) - mesh.point(mesh.from(h))).norm();
}

Vec3 center(const Mesh& mesh, FaceId face) {
  Vec3 sum = Vec3::Zero();
  for (int v : mesh.corners(face)) sum += mesh.point(VertexId(v));
  return sum / mesh.degree(face);
}

double corner_angle(const Mesh& mesh, HalfedgeId h) {
  const Vec3& p = mesh.point(mesh.from(h));
  const Vec3 out = mesh.point(mesh.to(h)) - p, in = mesh.point(mesh.from(mesh.prev(h))) - p;
  const Vec3 turn = out.cross(in);
  const double angle = plico::atan2(turn.norm(), out.dot(in));
  // A reflex corner of a polygon turns against the face's normal.
  const bool reflex = mesh.degree(mesh.face(h)) > 3 && turn.dot(normal(mesh, mesh.face(h))) < 0;
  return reflex ? 2 * kPi - angle : angle;
}

double fold_angle(const Mesh& mesh, EdgeId edge) {
  const HalfedgeId h = mesh.halfedge(edge), g = mesh.twin(h);
  if (!g.valid()) return 0;
  const Vec3 along = (mesh.point(mesh.to(h)) - mesh.point(mesh.from(h))).normalized();
  const Vec3 n1 = normal(mesh, mesh.face(h)), n2 = normal(mesh, mesh.face(g));
  return -plico::atan2(n1.cross(n2).dot(along), n1.dot(n2));
}

double angle_sum(const Mesh& mesh, VertexId v) {
  double sum = 0;
  const HalfedgeId start = mesh.halfedge(v);
  for (HalfedgeId h = start; h.valid();) {
    sum += corner_angle(mesh, h);
    h = mesh.twin(mesh.prev(h));
    if (h == start) break;
  }
  return sum;
}

bool is_boundary(const Mesh& mesh, VertexId v) {
  const HalfedgeId h = mesh.halfedge(v);
  return h.valid() && !mesh.twin(h).valid();
}

bool is_hyperbolic(const Mesh& mesh, VertexId v) {
  // A flat vertex sums to 2 pi only up to rounding.
  return !is_boundary(mesh, v) && angle_sum(mesh, v) > 2 * kPi + 1e-9;
}

Eigen::AlignedBox3d bounding_box(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.soup().points) box.extend(p);
  return box;
}

double diagonal(const Mesh& mesh) { return mesh.num_vertices() == 0 ? 0 : bounding_box(mesh).diagonal().norm(); }

double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (EdgeId e : mesh.edges()) sum += length(mesh, e);
  return mesh.num_edges() == 0 ? 0 : sum / mesh.num_edges();
}

double surface_area(const Mesh& mesh) {
  double sum = 0;
  for (FaceId f : mesh.faces()) sum += area(mesh, f);
  return sum;
}

double volume(const Mesh& mesh) {
  if (mesh.num_vertices() == 0) return 0;
  const Vec3 origin = mesh.soup().points[0];
  double sum = 0;
  for (FaceId f : mesh.faces())
    sum += (mesh.point(mesh.from(*mesh.halfedges(f).begin())) - origin).dot(twice_vector_area(mesh, f));
  return sum / 6;
}

Components components(const Mesh& mesh) {
  Components result;
  result.of_face.assign(mesh.num_faces(), -1);
  std::vector<FaceId> stack;
  for (FaceId seed : mesh.faces()) {
    if (result.of_face[seed] >= 0) continue;
    const int c = result.count++;
    result.of_face[seed] = c;
    stack.push_back(seed);
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (HalfedgeId h : mesh.halfedges(f)) {
        const HalfedgeId g = mesh.twin(h);
        if (!g.valid() || result.of_face[mesh.face(g)] >= 0) continue;
        result.of_face[mesh.face(g)] = c;
        stack.push_back(mesh.face(g));
      }
    }
  }
  return result;
}

std::vector<std::vector<VertexId>> boundary_loops(const Mesh& mesh) {
  std::vector<std::vector<VertexId>> loops;
  std::vector<char> done(mesh.num_halfedges(), 0);
  for (int i = 0; i < mesh.num_halfedges(); ++i) {
    HalfedgeId h(i);
    if (mesh.twin(h).valid() || done[h]) continue;
    loops.emplace_back();
    while (!done[h]) {
      done[h] = 1;
      loops.back().push_back(mesh.from(h));
      // Turn around to(h) until the next open side.
      h = mesh.next(h);
      while (mesh.twin(h).valid()) h = mesh.next(mesh.twin(h));
    }
  }
  return loops;
}

int genus(const Mesh& mesh) {
  int used = 0;
  for (VertexId v : mesh.vertices()) used += mesh.halfedge(v).valid();
  const int euler = used - mesh.num_edges() + mesh.num_faces();
  const int loops = static_cast<int>(boundary_loops(mesh).size());
  return components(mesh).count - (euler + loops) / 2;
}

bool is_closed(const Mesh& mesh) {
  for (EdgeId e : mesh.edges())
    if (mesh.is_boundary(e)) return false;
  return mesh.num_faces() > 0;
}

bool is_convex(const Mesh& mesh) {
  if (!is_closed(mesh) || components(mesh).count != 1 || genus(mesh) != 0) return false;
  for (EdgeId e : mesh.edges())
    if (fold_angle(mesh, e) > 1e-9) return false;
  return true;
}

}  // namespace plico
