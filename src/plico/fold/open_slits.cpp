#include "plico/fold/open_slits.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "plico/base/disjoint_sets.h"
#include "plico/mesh/face_sides.h"

namespace plico {
namespace {

class SlitOpener {
 public:
  explicit SlitOpener(const CreasePattern& sheet)
      : old_(sheet),
        sides_(edge_sides(sheet)),
        open_(sheet),
        first_corner_(first_corners(sheet)),
        groups_(first_corner_.back()) {}

  CreasePattern run() {
    const int edges = old_.num_edges();
    apart_.assign(old_.vertices.size(), 0);
    for (int e = 0; e < edges; ++e)
      if (is_slit(e)) apart_[old_.edges[e].a] = apart_[old_.edges[e].b] = 1;
    for (int e = 0; e < edges; ++e)
      if (joins(e) && !is_slit(e)) join_corners(e);
    name_corners();
    for (int e = 0; e < edges; ++e) place(e);
    for (const auto& [face, edge] : halves_) add_halves(face, edge);
    return std::move(open_);
  }

 private:
  // Of each panel, and the number of all corners.
  static std::vector<int> first_corners(const CreasePattern& sheet) {
    std::vector<int> first{0};
    for (const std::vector<int>& face : sheet.faces) first.push_back(first.back() + static_cast<int>(face.size()));
    return first;
  }

  bool joins(int e) const { return sides_[e].left >= 0 && sides_[e].right >= 0; }
  bool is_slit(int e) const { return joins(e) && old_.edges[e].assignment == Assignment::Cut; }

  int corner(int face, int vertex) const {
    const std::vector<int>& corners = old_.faces[face];
    return first_corner_[face] + static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  }

  void join_corners(int e) {
    for (const int v : {old_.edges[e].a, old_.edges[e].b})
      groups_.join(corner(sides_[e].left, v), corner(sides_[e].right, v));
  }

  // The first group of corners at a vertex keeps it, each further one gets its own.
  void name_corners() {
    std::vector<char> taken(old_.vertices.size(), 0);
    std::map<int, int> name;
    for (int f = 0; f < old_.num_faces(); ++f)
      for (std::size_t i = 0; i < old_.faces[f].size(); ++i) {
        const int v = old_.faces[f][i];
        if (!apart_[v]) continue;
        const auto [at, fresh] = name.try_emplace(groups_.find(first_corner_[f] + static_cast<int>(i)), v);
        if (fresh && taken[v]) at->second = add_vertex(old_.vertices[v]);
        taken[v] = 1;
        open_.faces[f][i] = at->second;
      }
  }

  int add_vertex(const Vec2& p) {
    open_.vertices.push_back(p);
    return open_.num_vertices() - 1;
  }

  int name_in(int face, int vertex) const { return open_.faces[face][corner(face, vertex) - first_corner_[face]]; }

  Crease on_side(int e, int face) const {
    Crease edge = old_.edges[e];
    edge.a = name_in(face, edge.a), edge.b = name_in(face, edge.b);
    return edge;
  }

  void place(int e) {
    const auto [left, right] = sides_[e];
    if (left < 0 && right < 0) return;
    open_.edges[e] = on_side(e, left >= 0 ? left : right);
    if (!is_slit(e)) return;
    const Crease other = on_side(e, right);
    if (other.a != open_.edges[e].a || other.b != open_.edges[e].b)
      open_.edges.push_back(other);
    else
      halves_.push_back({right, other});
  }

  // After all others, since corners are looked up by their place in the panel until then.
  void add_halves(int face, const Crease& edge) {
    const int middle = add_vertex((open_.vertices[edge.a] + open_.vertices[edge.b]) / 2);
    std::vector<int>& corners = open_.faces[face];
    const auto at = std::find(corners.begin(), corners.end(), edge.b);  // on its right the panel goes from b to a
    corners.insert(at + 1, middle);
    Crease half = edge;
    half.b = middle;
    open_.edges.push_back(half);
    half.a = middle, half.b = edge.b;
    open_.edges.push_back(half);
  }

  const CreasePattern& old_;
  std::vector<EdgeSides> sides_;
  CreasePattern open_;
  const std::vector<int> first_corner_;
  DisjointSets groups_;  // corners that hold together
  std::vector<char> apart_;
  std::vector<std::pair<int, Crease>> halves_;  // second sides that need a middle, with their panels
};

}  // namespace

CreasePattern open_slits(const CreasePattern& sheet) { return SlitOpener(sheet).run(); }

}  // namespace plico
