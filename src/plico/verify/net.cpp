#include "plico/verify/net.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/sort_in_buckets.h"
#include "plico/geom/polygon.h"
#include "plico/verify/closing.h"

namespace plico {
namespace {

// A side of a panel; sorted by its undirected key, the sides along one edge stand together.
struct Side {
  std::uint64_t key;
  int panel, corner;  // runs from this corner of the panel to the next
};

std::uint64_t undirected_key(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

int smaller_end(std::uint64_t key) { return static_cast<int>(key >> 32); }

class NetCheck {
 public:
  NetCheck(const Unfolding& net, const Mesh& mesh, const NetCheckOptions& options)
      : net_(net), sheet_(net.sheet), mesh_(mesh), options_(options) {}

  NetVerdict run(const Run& run) {
    verdict_.panels = sheet_.num_faces();
    if (!numbers_in_range()) return finish();
    measure();
    check_faces();
    collect_sides();
    check_edges();
    check_tree();
    check_parts();
    check_angles();
    check_mates();
    if (!failed_before_folding()) check_closing();
    if (run.over()) verdict_.complete = false;
    check_overlaps(run);
    return finish();
  }

 private:
  template <class... Args>
  void defect(const std::string& code, fmt::format_string<Args...> message, Args&&... args) {
    constexpr int kShown = 5;
    if (++count_[code] <= kShown) verdict_.defects.push_back({code, fmt::format(message, std::forward<Args>(args)...)});
  }

  NetVerdict finish() {
    for (const auto& [code, count] : count_)
      if (count > 5) verdict_.defects.push_back({code, fmt::format("and {} more of this kind", count - 5)});
    return std::move(verdict_);
  }

  // ---- Numbers ------------------------------------------------------------------------------------------------------

  bool numbers_in_range() {
    const auto all_below = [](const std::vector<int>& values, int low, int limit) {
      return std::all_of(values.begin(), values.end(), [&](int v) { return low <= v && v < limit; });
    };
    const std::size_t faces = sheet_.faces.size(), edges = sheet_.edges.size();
    const bool sizes = net_.mesh_face.size() == faces && net_.mesh_vertex.size() == sheet_.vertices.size() &&
                       net_.part.size() == faces && (net_.mate.empty() || net_.mate.size() == edges);
    if (!sizes) defect("net/numbers", "the net does not say for every panel and vertex where it came from");
    if (!all_below(net_.mesh_face, 0, mesh_.num_faces()) || !all_below(net_.mesh_vertex, 0, mesh_.num_vertices()))
      defect("net/other-mesh", "the net names faces or vertices that the mesh does not have");
    bool inside = all_below(net_.mate, -1, sheet_.num_edges());
    for (const std::vector<int>& face : sheet_.faces)
      inside = inside && face.size() >= 3 && all_below(face, 0, sheet_.num_vertices());
    for (const Crease& e : sheet_.edges)
      inside = inside && all_below({e.a, e.b}, 0, sheet_.num_vertices()) && e.a != e.b;
    if (!inside) defect("net/numbers", "the net names vertices or edges that it does not have");
    return verdict_.defects.empty();
  }

  const Vec2& flat(int panel, std::size_t i) const { return sheet_.vertices[sheet_.faces[panel][i]]; }
  Vec3 solid(int panel, std::size_t i) const { return mesh_.point(VertexId(net_.mesh_vertex[sheet_.faces[panel][i]])); }

  // Scale of the net (the median panel's, so that one wrong panel does not matter) and size of the mesh.
  void measure() {
    std::vector<double> ratios;
    for (int f = 0; f < sheet_.num_faces(); ++f) {
      double on_sheet = 0, in_space = 0;
      const std::size_t n = sheet_.faces[f].size();
      for (std::size_t i = 0; i < n; ++i) {
        on_sheet += (flat(f, i) - flat(f, (i + 1) % n)).norm();
        in_space += (solid(f, i) - solid(f, (i + 1) % n)).norm();
      }
      if (in_space > 0) ratios.push_back(on_sheet / in_space);
    }
    if (!ratios.empty()) {
      const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
      std::nth_element(ratios.begin(), middle, ratios.end());
      if (std::abs(*middle - 1) > 1e-9) verdict_.scale = *middle;
    }
    Eigen::AlignedBox3d box;
    for (VertexId v : mesh_.vertices()) box.extend(mesh_.point(v));
    diagonal_ = mesh_.num_vertices() == 0 ? 0 : verdict_.scale * box.diagonal().norm();
  }

  // ---- Faces --------------------------------------------------------------------------------------------------------

  void check_faces() {
    std::vector<int> panel_of(static_cast<std::size_t>(mesh_.num_faces()), -1);
    side_of_mesh_.assign(sheet_.faces.size(), -1);
    for (int f = 0; f < sheet_.num_faces(); ++f) {
      int& seen = panel_of[net_.mesh_face[f]];
      if (seen >= 0) defect("net/face-twice", "panels {} and {} are both mesh face {}", seen, f, net_.mesh_face[f]);
      seen = f;
      match_corners(f);
    }
    for (FaceId g : mesh_.faces())
      if (panel_of[g] < 0) defect("net/face-missing", "mesh face {} has no panel", int(g));
  }

  // Corner i of a panel is corner start + i of its mesh face.
  void match_corners(int f) {
    const std::vector<int>& face = sheet_.faces[f];
    const auto corners = mesh_.corners(FaceId(net_.mesh_face[f]));
    const std::size_t n = corners.size();
    const auto fits = [&](std::size_t start) {
      for (std::size_t i = 0; i < n; ++i)
        if (net_.mesh_vertex[face[i]] != corners[(start + i) % n]) return false;
      return true;
    };
    std::size_t start = 0;
    if (face.size() == n)
      while (start < n && !fits(start)) ++start;
    if (face.size() != n || start == n)
      return defect("net/corners", "panel {} does not have the corners of mesh face {} in their order", f,
                    net_.mesh_face[f]);
    side_of_mesh_[f] = static_cast<int>(start);
    check_congruence(f);
  }

  // The first corner but 0 of which the distance is largest.
  template <class Distance>
  static std::size_t farthest(std::size_t n, Distance distance) {
    std::size_t best = 1;
    double largest = distance(1);
    for (std::size_t i = 2; i < n; ++i) {
      const double here = distance(i);
      if (here > largest) largest = here, best = i;
    }
    return best;
  }

  // The distances from three corners that are not in line fix all others; the area's sign tells a mirror image.
  void check_congruence(int f) {
    const std::size_t n = sheet_.faces[f].size();
    const std::size_t far = farthest(n, [&](std::size_t i) { return (solid(f, i) - solid(f, 0)).norm(); });
    const Vec3 line = solid(f, far) - solid(f, 0);
    const std::size_t aside =
        farthest(n, [&](std::size_t i) { return (solid(f, i) - solid(f, 0)).cross(line).norm(); });
    double worst = 0;
    const auto compare = [&](std::size_t i, std::size_t k) {
      const double on_sheet = (flat(f, i) - flat(f, k)).norm(), in_space = (solid(f, i) - solid(f, k)).norm();
      worst = std::max(worst, std::abs(on_sheet - verdict_.scale * in_space));
    };
    for (std::size_t i = 1; i < n; ++i) {
      compare(i, 0);
      if (i != far) compare(i, far);
      if (i != far && i != aside) compare(i, aside);
    }
    verdict_.congruence_error = std::max(verdict_.congruence_error, worst / diagonal_);
    if (!(worst <= options_.tolerance * diagonal_))
      defect("net/not-congruent", "panel {} differs from mesh face {} by {:.3g} of the diagonal", f, net_.mesh_face[f],
             worst / diagonal_);
    else if (signed_area(polygon(sheet_, f)) < 0)
      defect("net/turned-over", "panel {} lies on its front", f);
  }

  // ---- Edges, tree, parts -------------------------------------------------------------------------------------------

  void collect_sides() {
    for (int f = 0; f < sheet_.num_faces(); ++f) {
      const std::vector<int>& face = sheet_.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i)
        sides_.push_back({undirected_key(face[i], face[(i + 1) % face.size()]), f, static_cast<int>(i)});
    }
    sort_in_buckets(
        sides_, sheet_.num_vertices(), [](const Side& s) { return smaller_end(s.key); },
        [](const Side& s, const Side& t) {
          return s.key != t.key ? s.key < t.key : s.panel != t.panel ? s.panel < t.panel : s.corner < t.corner;
        });
  }

  // Walks the sides and the edges, both sorted, side by side.
  void check_edges() {
    std::vector<std::pair<std::uint64_t, int>> edges;
    for (int e = 0; e < sheet_.num_edges(); ++e)
      edges.emplace_back(undirected_key(sheet_.edges[e].a, sheet_.edges[e].b), e);
    sort_in_buckets(
        edges, sheet_.num_vertices(), [](const auto& e) { return smaller_end(e.first); }, std::less<>());
    border_side_.assign(sheet_.edges.size(), -1);
    std::size_t at = 0;
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i + 1;
      while (end < sides_.size() && sides_[end].key == sides_[i].key) ++end;
      while (at < edges.size() && edges[at].first < sides_[i].key) loose_edge(edges[at++].second);
      if (at == edges.size() || edges[at].first != sides_[i].key)
        defect("net/edge-missing", "side {} of panel {} is not among the edges", sides_[i].corner, sides_[i].panel);
      else
        check_edge(edges[at++].second, i, end);
      i = end;
    }
    while (at < edges.size()) loose_edge(edges[at++].second);
    verdict_.fold_edges = static_cast<int>(folds_.size());
  }

  void loose_edge(int e) { defect("net/edge-loose", "edge {} is no side of a panel, or stands twice", e); }

  void check_edge(int e, std::size_t first, std::size_t end) {
    const bool border = sheet_.edges[e].assignment == Assignment::Boundary;
    const auto runs_along = [&](const Side& s) { return sheet_.faces[s.panel][s.corner] == sheet_.edges[e].a; };
    if (end - first == 1) {
      border_side_[e] = static_cast<int>(first);
      if (!border)
        defect("net/assignment", "edge {} on the border of panel {} is {}, not B", e, sides_[first].panel,
               static_cast<char>(sheet_.edges[e].assignment));
      return;
    }
    const Side &s = sides_[first], &t = sides_[first + 1];
    if (end - first > 2) return defect("net/edge-panels", "edge {} is a side of {} panels", e, end - first);
    if (runs_along(s) == runs_along(t))
      return defect("net/edge-panels", "panels {} and {} lie on the same side of edge {}", s.panel, t.panel, e);
    if (border) defect("net/assignment", "edge {} between panels {} and {} is B, not a fold", e, s.panel, t.panel);
    // Panels with the right corners are neighbours in the mesh too: it has only one halfedge from one vertex to
    // another.
    folds_.push_back({e, runs_along(s) ? s.panel : t.panel, runs_along(s) ? t.panel : s.panel});
  }

  HalfedgeId mesh_halfedge(const Side& s) const {
    if (side_of_mesh_[s.panel] < 0) return HalfedgeId();
    const int n = static_cast<int>(sheet_.faces[s.panel].size());
    const HalfedgeId first = *mesh_.halfedges(FaceId(net_.mesh_face[s.panel])).begin();
    return HalfedgeId(first + (side_of_mesh_[s.panel] + s.corner) % n);
  }

  int root(int panel) {
    while (root_[panel] != panel) panel = root_[panel] = root_[root_[panel]];
    return panel;
  }

  void check_tree() {
    root_.resize(sheet_.faces.size());
    std::iota(root_.begin(), root_.end(), 0);
    for (const NetFold& fold : folds_) {
      const int a = root(fold.left), b = root(fold.right);
      if (a == b)
        defect("net/cycle", "edge {} between panels {} and {} closes a cycle of panels", fold.edge, fold.left,
               fold.right);
      root_[std::max(a, b)] = std::min(a, b);
    }
  }

  void check_parts() {
    std::vector<int> first_of(sheet_.faces.size(), -1);  // the piece that has this part number
    std::vector<int> number_of(sheet_.faces.size(), -1);
    for (int f = 0; f < sheet_.num_faces(); ++f) {
      const int piece = root(f), part = net_.part[f];
      if (piece == f) ++verdict_.parts;
      if (part < 0 || part >= sheet_.num_faces()) {
        defect("net/parts", "panel {} has part number {}", f, part);
        continue;
      }
      if (first_of[part] < 0) first_of[part] = piece;
      if (number_of[piece] < 0) number_of[piece] = part;
      if (first_of[part] != piece)
        defect("net/parts", "panels {} and {} have part number {} but are not connected", first_of[part], f, part);
      else if (number_of[piece] != part)
        defect("net/parts", "panels {} and {} are connected but have part numbers {} and {}", piece, f,
               number_of[piece], part);
    }
    for (int part = 0; part < verdict_.parts; ++part)
      if (first_of[part] < 0) defect("net/parts", "there are {} parts but none has number {}", verdict_.parts, part);
  }

  // ---- Fold angles --------------------------------------------------------------------------------------------------

  // Newell's normal, about the first corner so that shapes far from the origin keep their digits.
  Vec3 mesh_normal(FaceId g) const {
    const auto corners = mesh_.corners(g);
    const Vec3& origin = mesh_.point(VertexId(corners[0]));
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i)
      sum += (mesh_.point(VertexId(corners[i - 1])) - origin).cross(mesh_.point(VertexId(corners[i])) - origin);
    return sum.normalized();
  }

  // From the normals' half angle, which keeps its digits near 0 and near 180 degrees; the second face rises above the
  // first one's plane in a valley.
  double mesh_fold_angle(const NetFold& fold) const {
    const Crease& e = sheet_.edges[fold.edge];
    const Vec3 along = mesh_.point(VertexId(net_.mesh_vertex[e.b])) - mesh_.point(VertexId(net_.mesh_vertex[e.a]));
    const Vec3 &n1 = normals_[net_.mesh_face[fold.left]], &n2 = normals_[net_.mesh_face[fold.right]];
    const double angle = 2 * plico::atan2((n1 - n2).norm(), (n1 + n2).norm());
    const Vec3 away = along.cross(n2);  // in the right face, away from the edge
    return away.dot(n1) < 0 ? -angle : angle;
  }

  void check_angles() {
    const double tolerance = radians(options_.angle_tolerance_deg);
    for (FaceId g : mesh_.faces()) normals_.push_back(mesh_normal(g));
    for (const NetFold& fold : folds_) {
      const Crease& e = sheet_.edges[fold.edge];
      const double wanted = mesh_fold_angle(fold);
      const double off = std::abs(std::remainder(e.fold_angle - wanted, 2 * kPi));
      verdict_.angle_error = std::max(verdict_.angle_error, off);
      if (!(off <= tolerance))
        defect("net/angle", "edge {} folds by {:.9g} degrees, the mesh by {:.9g}", fold.edge, degrees(e.fold_angle),
               degrees(wanted));
      const bool up = e.fold_angle > tolerance, down = e.fold_angle < -tolerance;
      const char letter = static_cast<char>(e.assignment);
      if ((letter == 'M' && up) || (letter == 'V' && down) || (letter == 'F' && (up || down)) || letter == 'C')
        defect("net/assignment", "edge {} folds by {:.9g} degrees but is {}", fold.edge, degrees(e.fold_angle), letter);
    }
  }

  // ---- Mates --------------------------------------------------------------------------------------------------------

  void check_mates() {
    if (net_.mate.empty()) return;
    for (int e = 0; e < sheet_.num_edges(); ++e) {
      const int mate = net_.mate[e];
      if (border_side_[e] < 0) {
        if (mate >= 0) defect("net/mate", "edge {} is not on the border but has mate {}", e, mate);
        continue;
      }
      const HalfedgeId h = mesh_halfedge(sides_[border_side_[e]]), twin = h.valid() ? mesh_.twin(h) : h;
      if (mate < 0) {
        if (twin.valid()) defect("net/mate", "edge {} is cut but has no mate", e);
        continue;
      }
      if (net_.mate[mate] != e) defect("net/mate", "edge {} has mate {}, which has mate {}", e, mate, net_.mate[mate]);
      if (border_side_[mate] < 0 || !twin.valid() || mesh_halfedge(sides_[border_side_[mate]]) != twin)
        defect("net/mate", "edges {} and {} are mates but not the same edge of the mesh", e, mate);
      compare_mates(e, mate);
    }
  }

  void compare_mates(int e, int mate) {
    const auto length = [&](int i) {
      return (sheet_.vertices[sheet_.edges[i].a] - sheet_.vertices[sheet_.edges[i].b]).norm();
    };
    const double off = std::abs(length(e) - length(mate)) / diagonal_;
    verdict_.mate_error = std::max(verdict_.mate_error, off);
    if (!(off <= options_.tolerance))
      defect("net/mate-length", "edges {} and {} are mates but differ by {:.3g} of the diagonal", e, mate, off);
  }

  // ---- Folding and overlap ------------------------------------------------------------------------------------------

  // Wrong numbers or a wrong tree leave nothing to fold.
  bool failed_before_folding() const {
    for (const char* code : {"net/corners", "net/face-twice", "net/face-missing", "net/cycle", "net/edge-panels"})
      if (count_.contains(code)) return true;
    return false;
  }

  void check_closing() {
    const Closing closing = fold_and_compare(net_, mesh_, folds_, verdict_.scale);
    verdict_.closing_error = closing.worst / diagonal_;
    if (closing.panel >= 0 && !(verdict_.closing_error <= options_.tolerance))
      defect("net/does-not-close", "folded, panel {} misses its mesh face by {:.3g} of the diagonal", closing.panel,
             verdict_.closing_error);
  }

  void check_overlaps(const Run& run) {
    verdict_.overlaps = find_overlaps(sheet_, options_.overlap, run);
    if (!verdict_.overlaps.complete) verdict_.complete = false;
    for (const OverlappingPair& pair : verdict_.overlaps.listed)
      defect("net/overlap", "panels {} and {} overlap by area {:.3g}", pair.a, pair.b, pair.area);
    if (verdict_.overlaps.count > 0)
      count_["net/overlap"] = static_cast<int>(std::min<long>(verdict_.overlaps.count, 1 << 30));
  }

  const Unfolding& net_;
  const CreasePattern& sheet_;
  const Mesh& mesh_;
  const NetCheckOptions& options_;
  NetVerdict verdict_;
  std::map<std::string, int> count_;  // defects of each kind
  double diagonal_ = 0;               // of the mesh, in the net's unit
  std::vector<int> side_of_mesh_;     // per panel: the corner of its mesh face that its first corner is, -1 for none
  std::vector<Side> sides_;
  std::vector<int> border_side_;  // per edge: its only side, -1 for folds
  std::vector<NetFold> folds_;
  std::vector<Vec3> normals_;  // of the mesh faces
  std::vector<int> root_;      // union-find over panels
};

}  // namespace

NetVerdict verify_net(const Unfolding& net, const Mesh& mesh, const NetCheckOptions& options, const Run& run) {
  return NetCheck(net, mesh, options).run(run);
}

}  // namespace plico
