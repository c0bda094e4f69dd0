#include "plico/fold/net_piece.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

// The piece of each edge, -1 for edges of no panel.
std::vector<int> piece_of_edges(const Unfolding& net, const std::vector<EdgeSides>& sides) {
  std::vector<int> piece;
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    const int left = sides[e].left, right = sides[e].right;
    piece.push_back(left >= 0 ? net.part[left] : right >= 0 ? net.part[right] : -1);
    if (is_hinge(net.sheet.edges[e], sides[e]) && net.part[left] != net.part[right])
      throw InvalidInput("fold/piece",
                         fmt::format("edge {} folds between pieces {} and {}", e, net.part[left], net.part[right]));
  }
  return piece;
}

class Pieces {
 public:
  explicit Pieces(const Unfolding& net) : net_(net), pieces_(net.num_parts()), number_(net.sheet.vertices.size(), -1) {}

  std::vector<NetPiece> run() {
    add_panels();
    for (NetPiece& piece : pieces_) add_vertices(piece);
    add_edges();
    return std::move(pieces_);
  }

 private:
  void add_panels() {
    for (int f = 0; f < net_.sheet.num_faces(); ++f) {
      NetPiece& piece = pieces_[net_.part[f]];
      piece.panel.push_back(f);
      piece.net.part.push_back(0);
      if (!net_.mesh_face.empty()) piece.net.mesh_face.push_back(net_.mesh_face[f]);
    }
  }

  // Panels of different pieces share no vertex in a net, but may in a sheet that someone drew.
  void add_vertices(NetPiece& piece) {
    for (int f : piece.panel)
      piece.vertex.insert(piece.vertex.end(), net_.sheet.faces[f].begin(), net_.sheet.faces[f].end());
    std::sort(piece.vertex.begin(), piece.vertex.end());
    piece.vertex.erase(std::unique(piece.vertex.begin(), piece.vertex.end()), piece.vertex.end());
    for (std::size_t i = 0; i < piece.vertex.size(); ++i) {
      const int v = piece.vertex[i];
      number_[v] = static_cast<int>(i);
      piece.net.sheet.vertices.push_back(net_.sheet.vertices[v]);
      if (!net_.mesh_vertex.empty()) piece.net.mesh_vertex.push_back(net_.mesh_vertex[v]);
    }
    for (int f : piece.panel) {
      std::vector<int>& face = piece.net.sheet.faces.emplace_back(net_.sheet.faces[f]);
      for (int& v : face) v = number_[v];
    }
  }

  void add_edges() {
    const std::vector<EdgeSides> sides = edge_sides(net_.sheet);
    const std::vector<int> owner = piece_of_edges(net_, sides);
    const std::vector<int> hinge = hinge_of_edge(net_.sheet);
    std::vector<int> number(owner.size(), -1);
    for (std::size_t e = 0; e < owner.size(); ++e) {
      if (owner[e] < 0) continue;
      NetPiece& piece = pieces_[owner[e]];
      number[e] = static_cast<int>(piece.edge.size());
      piece.edge.push_back(static_cast<int>(e));
      piece.net.sheet.edges.push_back(in_piece(piece, net_.sheet.edges[e]));
      if (hinge[e] >= 0) piece.hinge.push_back(hinge[e]);
      if (!net_.mesh_edge.empty()) piece.net.mesh_edge.push_back(net_.mesh_edge[e]);
    }
    if (net_.mate.empty()) return;
    for (NetPiece& piece : pieces_)
      for (int e : piece.edge) {
        const int mate = net_.mate[e];
        piece.net.mate.push_back(mate >= 0 && owner[mate] == owner[e] ? number[mate] : -1);
      }
  }

  static Crease in_piece(const NetPiece& piece, Crease crease) {
    for (int* end : {&crease.a, &crease.b})
      *end = static_cast<int>(std::lower_bound(piece.vertex.begin(), piece.vertex.end(), *end) - piece.vertex.begin());
    return crease;
  }

  const Unfolding& net_;
  std::vector<NetPiece> pieces_;
  std::vector<int> number_;  // of each vertex in the piece at work
};

std::vector<double> times_of(const std::vector<std::optional<FoldingPath>>& paths) {
  std::vector<double> times{0, 1};
  for (const std::optional<FoldingPath>& path : paths)
    if (path)
      for (const Waypoint& waypoint : path->waypoints) times.push_back(waypoint.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

std::vector<NetPiece> pieces_of(const Unfolding& net) { return Pieces(net).run(); }

FoldingPath path_of_piece(const NetPiece& piece, const FoldingPath& whole) {
  FoldingPath path;
  for (const Waypoint& waypoint : whole.waypoints) {
    Configuration& config = path.waypoints.emplace_back(Waypoint{waypoint.time, {}}).config;
    config.resize(static_cast<Eigen::Index>(piece.hinge.size()));
    for (std::size_t h = 0; h < piece.hinge.size(); ++h)
      config[static_cast<Eigen::Index>(h)] = waypoint.config[piece.hinge[h]];
  }
  return path;
}

FoldingPath joined_path(const Linkage& whole, const std::vector<NetPiece>& pieces,
                        const std::vector<std::optional<FoldingPath>>& paths) {
  PLICO_ASSERT(pieces.size() == paths.size());
  FoldingPath joined;
  const Configuration end = goal(whole);
  for (double time : times_of(paths)) joined.waypoints.push_back({time, time * end});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!paths[i]) continue;
    for (Waypoint& waypoint : joined.waypoints) {
      const Configuration config = paths[i]->at(waypoint.time);
      for (std::size_t h = 0; h < pieces[i].hinge.size(); ++h)
        waypoint.config[pieces[i].hinge[h]] = config[static_cast<Eigen::Index>(h)];
    }
  }
  return joined;
}

}  // namespace plico
