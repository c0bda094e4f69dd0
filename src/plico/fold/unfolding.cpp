#include "plico/fold/unfolding.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr int kPartsInARow = 100;

// Lays one part after another while walking the trees.
class Layout {
 public:
  Layout(const Mesh& mesh, const FoldForest& forest) : mesh_(mesh), forest_(forest) {
    net_.sheet.faces.resize(mesh.num_faces());
    net_.mesh_face.resize(mesh.num_faces());
    net_.part.assign(mesh.num_faces(), -1);
    net_vertex_.assign(mesh.num_halfedges(), -1);
  }

  Unfolding run() {
    int parts = 0;
    for (FaceId root : mesh_.faces())
      if (net_.part[root] < 0) lay_part(root, parts++);
    collect_faces();
    add_edges();
    return std::move(net_);
  }

 private:
  void lay_part(FaceId root, int part) {
    const int first = net_.sheet.num_vertices();
    const std::vector<Vec2> flat = flat_corners(mesh_, root);
    int i = 0;
    for (HalfedgeId h : mesh_.halfedges(root)) add_vertex(h, flat[i++]);
    net_.part[root] = part;
    std::vector<FaceId> queue{root};
    for (std::size_t at = 0; at < queue.size(); ++at) {
      for (HalfedgeId h : mesh_.halfedges(queue[at])) {
        if (!forest_.is_fold[mesh_.edge(h)]) continue;
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid())
          throw InvalidInput("unfold/fold-on-boundary",
                             fmt::format("boundary edge {} is marked as a fold", int(mesh_.edge(h))));
        if (net_.part[mesh_.face(g)] >= 0) {
          if (net_vertex_[g] != net_vertex_[mesh_.next(h)] || net_vertex_[mesh_.next(g)] != net_vertex_[h])
            throw InvalidInput("unfold/cycle",
                               fmt::format("the fold edges around face {} close a cycle", int(mesh_.face(g))));
          continue;  // the panel we came from
        }
        lay_beside(h, g);
        net_.part[mesh_.face(g)] = part;
        queue.push_back(mesh_.face(g));
      }
    }
    move_beside_others(first);
  }

  // Places the face of g against the side h that is already laid.
  void lay_beside(HalfedgeId h, HalfedgeId g) {
    net_vertex_[g] = net_vertex_[mesh_.next(h)];
    net_vertex_[mesh_.next(g)] = net_vertex_[h];
    const Vec2 &from = net_.sheet.vertices[net_vertex_[g]], &to = net_.sheet.vertices[net_vertex_[mesh_.next(g)]];
    const Vec2 x = (to - from).normalized(), y = perpendicular(x), origin = from;
    const Vec3& base = mesh_.point(mesh_.from(g));
    const Vec3 x3 = (mesh_.point(mesh_.to(g)) - base).normalized(), y3 = normal(mesh_, mesh_.face(g)).cross(x3);
    for (HalfedgeId k = mesh_.next(mesh_.next(g)); k != g; k = mesh_.next(k)) {
      const Vec3 d = mesh_.point(mesh_.from(k)) - base;
      add_vertex(k, origin + d.dot(x3) * x + d.dot(y3) * y);
    }
  }

  void add_vertex(HalfedgeId h, const Vec2& at) {
    net_vertex_[h] = net_.sheet.num_vertices();
    net_.sheet.vertices.push_back(at);
    net_.mesh_vertex.push_back(mesh_.from(h));
  }

  // In one row, or in several: far from the origin coordinates are coarse, and panels that touch would overlap.
  void move_beside_others(int first) {
    Eigen::AlignedBox2d box;
    for (int v = first; v < net_.sheet.num_vertices(); ++v) box.extend(net_.sheet.vertices[v]);
    if (first == 0) {
      gap_ = 0.05 * box.diagonal().norm();
    } else {
      Vec2 shift(right_ + gap_ - box.min().x(), 0);
      if (in_row_ == kPartsInARow) {
        in_row_ = 0;
        bottom_ = top_ + gap_;
        shift.x() = -box.min().x();
      }
      if (bottom_) shift.y() = *bottom_ - box.min().y();
      for (int v = first; v < net_.sheet.num_vertices(); ++v) net_.sheet.vertices[v] += shift;
      box.translate(shift);
    }
    ++in_row_;
    right_ = box.max().x();
    top_ = std::max(top_, box.max().y());
  }

  void collect_faces() {
    for (FaceId f : mesh_.faces()) {
      net_.mesh_face[f] = f;
      for (HalfedgeId h : mesh_.halfedges(f)) net_.sheet.faces[f].push_back(net_vertex_[h]);
    }
  }

  void add_edges() {
    std::vector<int> edge_at(mesh_.num_halfedges(), -1);
    for (FaceId f : mesh_.faces()) {
      for (HalfedgeId h : mesh_.halfedges(f)) {
        const EdgeId e = mesh_.edge(h);
        const HalfedgeId g = mesh_.twin(h);
        const bool fold = forest_.is_fold[e];
        if (fold && edge_at[g] >= 0) continue;  // drawn from the other side
        edge_at[h] = net_.sheet.num_edges();
        const double angle = fold ? fold_angle(mesh_, e) : 0;
        net_.sheet.edges.push_back(
            {net_vertex_[h], net_vertex_[mesh_.next(h)], fold ? assignment_of(angle) : Assignment::Boundary, angle});
        net_.mesh_edge.push_back(e);
        net_.mate.push_back(-1);
        if (fold || !g.valid() || edge_at[g] < 0) continue;
        net_.mate[edge_at[h]] = edge_at[g];
        net_.mate[edge_at[g]] = edge_at[h];
      }
    }
  }

  const Mesh& mesh_;
  const FoldForest& forest_;
  Unfolding net_;
  std::vector<int> net_vertex_;  // of each halfedge's from-corner
  double right_ = 0, top_ = 0, gap_ = 0;
  std::optional<double> bottom_;  // of a row that is not the first
  int in_row_ = 0;
};

}  // namespace

std::vector<Vec2> flat_corners(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.corners(face);
  const Vec3& origin = mesh.point(VertexId(corners[0]));
  const Vec3 x = (mesh.point(VertexId(corners[1])) - origin).normalized();
  const Vec3 y = normal(mesh, face).cross(x);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (int v : corners) {
    const Vec3 d = mesh.point(VertexId(v)) - origin;
    flat.emplace_back(d.dot(x), d.dot(y));
  }
  return flat;
}

int Unfolding::num_parts() const { return part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1; }

Unfolding lay_flat(const Mesh& mesh, const FoldForest& forest) {
  PLICO_ASSERT(static_cast<int>(forest.is_fold.size()) == mesh.num_edges());
  return Layout(mesh, forest).run();
}

FoldForest forest_of(const Mesh& mesh, const Unfolding& unfolding) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (int e = 0; e < unfolding.sheet.num_edges(); ++e)
    if (unfolding.sheet.edges[e].assignment != Assignment::Boundary) forest.is_fold[unfolding.mesh_edge[e]] = 1;
  return forest;
}

}  // namespace plico
