#include "plico/fabricate/net_sides.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "plico/base/error.h"

namespace plico {
namespace {

bool is_boundary(const Crease& edge) {
  return edge.assignment == Assignment::Boundary || edge.assignment == Assignment::Cut;
}

std::uint64_t pair_key(int a, int b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

// Disjoint sets of small integers with path halving.
class Sets {
 public:
  explicit Sets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) { parent_[std::max(find(i), find(j))] = std::min(find(i), find(j)); }

 private:
  std::vector<int> parent_;
};

}  // namespace

NetSides::NetSides(const Unfolding& net)
    : net_(net), side_edge_(net.sheet.num_faces()), first_(net.sheet.num_edges()), second_(net.sheet.num_edges()) {
  std::unordered_map<std::uint64_t, int> edge_of;
  edge_of.reserve(net.sheet.edges.size());
  for (int e = 0; e < net.sheet.num_edges(); ++e)
    edge_of.emplace(pair_key(net.sheet.edges[e].a, net.sheet.edges[e].b), e);
  for (int f = 0; f < net.sheet.num_faces(); ++f) {
    const auto& face = net.sheet.faces[f];
    for (int i = 0; i < static_cast<int>(face.size()); ++i) {
      const auto found = edge_of.find(pair_key(face[i], face[(i + 1) % face.size()]));
      if (found == edge_of.end())
        throw InvalidInput("fabricate/no-edge", fmt::format("side {} of panel {} is no edge of the sheet", i, f));
      const int e = found->second;
      side_edge_[f].push_back(e);
      PanelSide& free = first_[e].panel < 0 ? first_[e] : second_[e];
      if (free.panel >= 0)
        throw InvalidInput("fabricate/three-panels", fmt::format("edge {} has more than two panels", e));
      free = {f, i};
      if (free.panel >= 0 && second_[e].panel >= 0 && is_boundary(net.sheet.edges[e]))
        throw InvalidInput("fabricate/joined-cut", fmt::format("edge {} is cut but joins two panels", e), {},
                           "write a cut as two boundary edges");
    }
  }
}

PanelSide NetSides::next_on_boundary(PanelSide s) const {
  const auto turn = [&](PanelSide t) {
    return PanelSide{t.panel, (t.side + 1) % static_cast<int>(side_edge_[t.panel].size())};
  };
  PanelSide t = turn(s);
  while (is_fold(edge(t.panel, t.side))) {
    const int e = edge(t.panel, t.side);
    t = turn(first_[e].panel == t.panel && first_[e].side == t.side ? second_[e] : first_[e]);
  }
  return t;
}

std::vector<std::vector<std::vector<int>>> NetSides::outlines() const {
  std::vector<std::vector<std::vector<int>>> loops(net_.num_parts());
  std::vector<char> walked(first_.size(), 0);
  for (int e = 0; e < static_cast<int>(first_.size()); ++e) {
    if (walked[e] || is_fold(e) || first_[e].panel < 0) continue;
    std::vector<int> loop;
    for (PanelSide s = first_[e]; !walked[edge(s.panel, s.side)]; s = next_on_boundary(s)) {
      loop.push_back(edge(s.panel, s.side));
      walked[loop.back()] = 1;
    }
    loops[net_.part[first_[e].panel]].push_back(std::move(loop));
  }
  return loops;
}

Unfolding cut_folds(const Unfolding& net, const std::vector<char>& is_cut) {
  const NetSides sides(net);
  std::vector<int> first_corner(net.sheet.num_faces() + 1, 0);
  for (int f = 0; f < net.sheet.num_faces(); ++f)
    first_corner[f + 1] = first_corner[f] + static_cast<int>(net.sheet.faces[f].size());
  const auto corner = [&](int f, int i) { return first_corner[f] + i % static_cast<int>(net.sheet.faces[f].size()); };
  // Corners that the remaining folds join are one vertex.
  Sets corners(first_corner.back()), panels(net.sheet.num_faces());
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    if (!sides.is_fold(e) || is_cut[e]) continue;
    const PanelSide s = sides.side(e), t = sides.second_side(e);
    corners.join(corner(s.panel, s.side), corner(t.panel, t.side + 1));
    corners.join(corner(s.panel, s.side + 1), corner(t.panel, t.side));
    panels.join(s.panel, t.panel);
  }

  Unfolding result;
  result.mesh_face = net.mesh_face;
  result.sheet.faces.resize(net.sheet.faces.size());
  std::vector<int> vertex_of(first_corner.back(), -1), part_of(net.sheet.num_faces(), -1);
  int parts = 0;
  for (int f = 0; f < net.sheet.num_faces(); ++f) {
    int& part = part_of[panels.find(f)];
    if (part < 0) part = parts++;
    result.part.push_back(part);
    for (int i = 0; i < static_cast<int>(net.sheet.faces[f].size()); ++i) {
      int& v = vertex_of[corners.find(corner(f, i))];
      if (v < 0) {
        v = result.sheet.num_vertices();
        result.sheet.vertices.push_back(net.sheet.vertices[net.sheet.faces[f][i]]);
        if (!net.mesh_vertex.empty()) result.mesh_vertex.push_back(net.mesh_vertex[net.sheet.faces[f][i]]);
      }
      result.sheet.faces[f].push_back(v);
    }
  }
  // Old edges keep their numbers; the second side of a new cut is appended.
  const auto ends = [&](PanelSide s) {
    const auto& face = result.sheet.faces[s.panel];
    return std::pair(face[s.side], face[(s.side + 1) % face.size()]);
  };
  result.sheet.edges = net.sheet.edges;
  result.mate = net.mate;
  result.mesh_edge = net.mesh_edge;
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    if (sides.side(e).panel < 0) continue;
    Crease& edge = result.sheet.edges[e];
    std::tie(edge.a, edge.b) = ends(sides.side(e));
    if (!sides.is_fold(e) || !is_cut[e]) continue;
    edge.assignment = Assignment::Boundary;  // the fold angle stays: it is the seam's
    Crease other = edge;
    std::tie(other.a, other.b) = ends(sides.second_side(e));
    result.mate[e] = result.sheet.num_edges();
    result.mate.push_back(e);
    if (!net.mesh_edge.empty()) result.mesh_edge.push_back(net.mesh_edge[e]);
    result.sheet.edges.push_back(other);
  }
  return result;
}

}  // namespace plico
