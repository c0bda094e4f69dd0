#include "plico/mesh/simplify.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <queue>
#include <tuple>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/point_distance.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

// Sum of squared distances to planes and points, weighted: x'Ax - 2 b'x + c.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;

  void add_plane(const Vec3& n, const Vec3& on, double weight) {
    const double d = n.dot(on);
    a += weight * n * n.transpose();
    b += weight * d * n;
    c += weight * d * d;
  }
  void add_point(const Vec3& p, double weight) {
    a += weight * Eigen::Matrix3d::Identity();
    b += weight * p;
    c += weight * p.squaredNorm();
  }
  void add(const Quadric& o) {
    a += o.a;
    b += o.b;
    c += o.c;
  }
  // That of the image: its value at a point is that of this one at the point's image.
  Quadric mirrored(const MirrorPlane& plane) const {
    const Eigen::Matrix3d turn = Eigen::Matrix3d::Identity() - 2 * plane.across * plane.across.transpose();
    const Vec3 shift = plane.image(Vec3::Zero());
    Quadric image;
    image.a = turn * a * turn;
    image.b = turn * (b - a * shift);
    image.c = c - 2 * b.dot(shift) + shift.dot(a * shift);
    return image;
  }
  double operator()(const Vec3& x) const { return x.dot(a * x) - 2 * b.dot(x) + c; }
};

// What a collapse may do to the faces around it.
struct Limits {
  double turn;   // smallest cosine between a face's normals before and after
  double shape;  // smallest quality (1 equilateral, 0 degenerate) of a face, unless it was worse before
};
// Tried one after the other, when nothing more can be collapsed under the one before.
constexpr std::array kLimits = {Limits{0.4, 0.12}, Limits{0.2, 0.06}, Limits{0.05, 0.02}};

constexpr double kFlat = 0.94;  // cosine between normals of faces that may exchange an edge
constexpr int kEveningRounds = 6;
constexpr double kBoundaryWeight = 10;

struct Candidate {
  double cost;
  int u, v;
  int version_u, version_v;
  bool operator<(const Candidate& o) const { return std::tie(o.cost, o.u, o.v) < std::tie(cost, u, v); }
};

using Triangle = std::array<int, 3>;

class Simplifier {
 public:
  // With a plane, vertices on it stay on it, each in one place of the seam with the image (with_image()).
  Simplifier(const Mesh& mesh, double evenness, const MirrorPlane* plane = nullptr, std::vector<char> on_plane = {})
      : plane_(plane),
        on_plane_(plane ? std::move(on_plane) : std::vector<char>(mesh.num_vertices(), 0)),
        points_(mesh.soup().points),
        faces_of_(mesh.num_vertices()),
        quadric_(mesh.num_vertices()),
        version_(mesh.num_vertices(), 0),
        on_boundary_(mesh.num_vertices(), 0) {
    const double center_weight = evenness / 3;
    for (FaceId f : mesh.faces()) {
      const auto c = mesh.corners(f);
      faces_.push_back({c[0], c[1], c[2]});
      for (int v : c) {
        faces_of_[v].push_back(f);
        quadric_[v].add_plane(normal(mesh, f), points_[v], area(mesh, f) / 3);
        quadric_[v].add_point(points_[v], area(mesh, f) * center_weight);
      }
    }
    for (int v = 0; v < mesh.num_vertices(); ++v)
      if (on_plane_[v]) quadric_[v].add(quadric_[v].mirrored(*plane_));
    num_faces_ = mesh.num_faces();
    for (EdgeId e : mesh.edges()) {
      if (!mesh.is_boundary(e)) continue;
      const HalfedgeId h = mesh.halfedge(e);
      on_boundary_[mesh.from(h)] = on_boundary_[mesh.to(h)] = 1;
      if (!on_plane_[mesh.from(h)] || !on_plane_[mesh.to(h)]) hold_boundary(mesh, h);
    }
  }

  void reduce_to(int target) {
    for (const Limits& limits : kLimits) {
      limits_ = limits;
      queue_ = {};
      for (const Triangle& t : faces_)
        for (int k = 0; k < 3; ++k)
          if (t[k] >= 0 && t[k] < t[(k + 1) % 3]) offer(t[k], t[(k + 1) % 3]);
      while (num_faces_ > target && !queue_.empty()) collapse_next();
      if (num_faces_ <= target) return;
    }
  }

  // Better shaped triangles on the same surface: edges are flipped and vertices slide in their tangent planes.
  void even_out(int rounds, bool keep_sharp) {
    keep_sharp_ = keep_sharp;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < 3; ++k) flip_if_better(static_cast<int>(f), k);
      for (std::size_t v = 0; v < points_.size(); ++v) slide(static_cast<int>(v));
    }
  }

  // With the vertices that lie on the plane, when there is one.
  HalfMesh result() const {
    HalfMesh half;
    PolygonSoup& soup = half.soup;
    std::vector<int> number(points_.size(), -1);
    for (const Triangle& t : faces_) {
      if (t[0] < 0) continue;
      for (int v : t) {
        if (number[v] >= 0) continue;
        number[v] = soup.num_points();
        soup.points.push_back(points_[v]);
        half.on_plane.push_back(on_plane_[v]);
      }
      soup.add_face({number[t[0]], number[t[1]], number[t[2]]});
    }
    return half;
  }

 private:
  // A plane through the edge, across its face, weighs more than what the face itself asks for.
  void hold_boundary(const Mesh& mesh, HalfedgeId h) {
    const Vec3& from = mesh.point(mesh.from(h));
    const Vec3 along = mesh.point(mesh.to(h)) - from;
    const Vec3 across = along.cross(normal(mesh, mesh.face(h))).normalized();
    for (VertexId v : {mesh.from(h), mesh.to(h)})
      quadric_[v].add_plane(across, from, kBoundaryWeight * along.squaredNorm());
  }

  void offer(int u, int v) {
    if (u > v) std::swap(u, v);
    const Quadric q = joined(u, v);
    queue_.push({q(replacement(q, u, v)), u, v, version_[u], version_[v]});
  }

  // What a vertex of the half brings to the plane, its image brings, too.
  Quadric joined(int u, int v) const {
    Quadric q = quadric_[u];
    q.add(quadric_[v]);
    if (on_plane_[u] != on_plane_[v]) q.add(quadric_[on_plane_[u] ? v : u].mirrored(*plane_));
    return q;
  }

  Vec3 replacement(const Quadric& q, int u, int v) const {
    const Vec3 best = best_point(q, u, v);
    return on_plane_[u] || on_plane_[v] ? plane_->foot(best) : best;
  }

  // Edges between vertices on the plane lie on the seam; another one would coincide with its image.
  bool keeps_seam(int u, int v) {
    if (on_plane_[u] == on_plane_[v]) return true;
    const int off = on_plane_[u] ? v : u, on = on_plane_[u] ? u : v;
    for (int w : neighbors(off, around_v_))
      if (w != on && on_plane_[w] && num_faces_between(on, w) != 1) return false;
    return true;
  }

  // Where the two vertices are best replaced; their middle when the quadric does not say, or says far away.
  Vec3 best_point(const Quadric& q, int u, int v) const {
    const Vec3 middle = (points_[u] + points_[v]) / 2;
    Eigen::Matrix3d inverse;
    bool invertible = false;
    q.a.computeInverseWithCheck(inverse, invertible, 1e-300);
    if (!invertible) return middle;
    const Vec3 best = middle + inverse * (q.b - q.a * middle);
    const bool usable = best.allFinite() && (best - middle).squaredNorm() <= (points_[u] - points_[v]).squaredNorm();
    return usable ? best : middle;
  }

  void collapse_next() {
    const Candidate next = queue_.top();
    queue_.pop();
    const auto [cost, u, v, version_u, version_v] = next;
    if (version_[u] != version_u || version_[v] != version_v || !keeps_topology(u, v) || !keeps_seam(u, v)) return;
    const Quadric q = joined(u, v);
    const Vec3 at = replacement(q, u, v);
    if (!keeps_shape(u, v, at) || !keeps_shape(v, u, at)) return;
    collapse(u, v, at);
    quadric_[u] = q;
    offer_around(u);
  }

  // Vertices next to v, each once.
  const std::vector<int>& neighbors(int v, std::vector<int>& list) const {
    list.clear();
    for (int f : faces_of_[v])
      for (int w : faces_[f])
        if (w != v) list.push_back(w);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  // The link condition: u and v have no common neighbors but the tips of their two common faces (Dey et al. 1999).
  bool keeps_topology(int u, int v) {
    if (num_faces_ <= 4) return false;
    neighbors(u, around_u_);
    neighbors(v, around_v_);
    common_.clear();
    std::set_intersection(around_u_.begin(), around_u_.end(), around_v_.begin(), around_v_.end(),
                          std::back_inserter(common_));
    const bool both_on_boundary = on_boundary_[u] && on_boundary_[v];
    if (common_.size() != (both_on_boundary ? 1 : 2)) return false;
    if (both_on_boundary && num_faces_between(u, v) != 1) return false;  // would pinch the surface
    return std::all_of(common_.begin(), common_.end(),
                       [&](int tip) { return faces_of_[tip].size() > (on_boundary_[tip] ? 1 : 3); });
  }

  int num_faces_between(int u, int v) const {
    return static_cast<int>(std::count_if(faces_of_[u].begin(), faces_of_[u].end(), [&](int f) {
      return std::find(faces_[f].begin(), faces_[f].end(), v) != faces_[f].end();
    }));
  }

  // 4 sqrt(3) area / sum of squared sides: 1 equilateral, 0 degenerate.
  static double quality(const Vec3& doubled_area, const std::array<Vec3, 3>& p) {
    const double sides = (p[1] - p[0]).squaredNorm() + (p[2] - p[1]).squaredNorm() + (p[0] - p[2]).squaredNorm();
    return sides > 0 ? 2 * std::sqrt(3.0) * doubled_area.norm() / sides : 0;
  }

  bool keeps_shape(int moved, int other, const Vec3& at) const {
    for (int f : faces_of_[moved]) {
      const Triangle& t = faces_[f];
      if (t[0] == other || t[1] == other || t[2] == other) continue;
      std::array<Vec3, 3> p{points_[t[0]], points_[t[1]], points_[t[2]]};
      const Vec3 before = (p[1] - p[0]).cross(p[2] - p[0]);
      const double was = quality(before, p);
      for (int k = 0; k < 3; ++k)
        if (t[k] == moved) p[k] = at;
      const Vec3 after = (p[1] - p[0]).cross(p[2] - p[0]);
      if (after.dot(before) < limits_.turn * after.norm() * before.norm()) return false;
      if (quality(after, p) < std::min(limits_.shape, was)) return false;
    }
    return true;
  }

  Vec3 doubled_area(const Triangle& t) const {
    return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
  }
  double quality(const Triangle& t) const {
    return quality(doubled_area(t), {points_[t[0]], points_[t[1]], points_[t[2]]});
  }
  static bool alike(const Vec3& a, const Vec3& b) { return a.dot(b) > kFlat * a.norm() * b.norm(); }

  int face_beyond(int face, int u, int v) const {
    for (int f : faces_of_[u])
      if (f != face && std::find(faces_[f].begin(), faces_[f].end(), v) != faces_[f].end()) return f;
    return -1;
  }

  // The k-th edge u -> v of a face with tip a, and the tip b beyond it: replaced by a -> b where the two faces are
  // almost one plane, the worse of them becomes better, and there is no such edge yet.
  void flip_if_better(int f, int k) {
    const Triangle t = faces_[f];
    if (t[0] < 0) return;
    const int u = t[k], v = t[(k + 1) % 3], a = t[(k + 2) % 3], g = face_beyond(f, u, v);
    if (g < 0) return;
    const int b = faces_[g][0] + faces_[g][1] + faces_[g][2] - u - v;
    const Triangle one{a, u, b}, two{b, v, a};
    if (std::min(quality(one), quality(two)) <= 1.0001 * std::min(quality(t), quality(faces_[g]))) return;
    const Vec3 before = doubled_area(t) + doubled_area(faces_[g]);
    if (!alike(doubled_area(t), doubled_area(faces_[g])) || !alike(doubled_area(one), before) ||
        !alike(doubled_area(two), before) || faces_of_[u].size() <= 3 || faces_of_[v].size() <= 3)
      return;
    neighbors(a, around_u_);
    if (std::binary_search(around_u_.begin(), around_u_.end(), b) || (on_plane_[a] && on_plane_[b])) return;
    faces_[f] = one;
    faces_[g] = two;
    std::erase(faces_of_[u], g);
    std::erase(faces_of_[v], f);
    faces_of_[a].push_back(g);
    faces_of_[b].push_back(f);
  }

  bool is_sharp(int v) const {
    for (int f : faces_of_[v])
      if (!alike(doubled_area(faces_[f]), doubled_area(faces_[faces_of_[v].front()]))) return true;
    return false;
  }

  // To the middle of its neighbors, as far as the tangent plane allows; only if the worst face becomes better.
  void slide(int v) {
    if (faces_of_[v].empty() || on_boundary_[v] || (keep_sharp_ && is_sharp(v))) return;
    Vec3 across = Vec3::Zero(), middle = Vec3::Zero();
    for (int f : faces_of_[v]) across += doubled_area(faces_[f]);
    for (int w : neighbors(v, around_v_)) middle += points_[w] / static_cast<double>(around_v_.size());
    across.normalize();
    const Vec3 was = points_[v], to = middle - was;
    std::vector<Vec3> before;
    double worst_before = 1, worst_after = 1;
    for (int f : faces_of_[v]) {
      before.push_back(doubled_area(faces_[f]));
      worst_before = std::min(worst_before, quality(faces_[f]));
    }
    points_[v] = was + to - across * across.dot(to);
    bool kept = true;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Triangle& t = faces_[faces_of_[v][i]];
      kept = kept && alike(before[i], doubled_area(t));
      worst_after = std::min(worst_after, quality(t));
    }
    if (!kept || worst_after <= worst_before) points_[v] = was;
  }

  void collapse(int u, int v, const Vec3& at) {
    for (int f : faces_of_[v]) {
      Triangle& t = faces_[f];
      if (t[0] == u || t[1] == u || t[2] == u) {
        for (int w : t)
          if (w != v) std::erase(faces_of_[w], f);
        t.fill(-1);
        --num_faces_;
      } else {
        std::replace(t.begin(), t.end(), v, u);
        faces_of_[u].push_back(f);
      }
    }
    faces_of_[v].clear();
    points_[u] = at;
    on_boundary_[u] = on_boundary_[u] || on_boundary_[v];
    on_plane_[u] = on_plane_[u] || on_plane_[v];
    ++version_[v];
  }

  // The edges at u have new costs; those across its faces may be free to collapse now.
  void offer_around(int u) {
    ++version_[u];
    for (int w : neighbors(u, around_u_)) offer(u, w);
    for (int f : faces_of_[u]) {
      const Triangle& t = faces_[f];
      for (int k = 0; k < 3; ++k)
        if (t[k] == u) offer(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
  }

  const MirrorPlane* plane_;
  std::vector<char> on_plane_;
  std::vector<Vec3> points_;
  std::vector<Triangle> faces_;  // {-1, -1, -1} when gone
  std::vector<std::vector<int>> faces_of_;
  std::vector<Quadric> quadric_;
  std::vector<int> version_;  // a candidate counts only while both its vertices are as they were
  std::vector<char> on_boundary_;
  bool keep_sharp_ = false;
  std::priority_queue<Candidate> queue_;
  Limits limits_ = kLimits[0];
  int num_faces_ = 0;
  std::vector<int> around_u_, around_v_, common_;
};

}  // namespace

void check(const SimplifyOptions& options) {
  require(options.faces >= 4, "faces", options.faces, "at least 4");
  require(options.evenness >= 0 && std::isfinite(options.evenness), "evenness", options.evenness, "at least 0");
}

PolygonSoup simplified(const Mesh& mesh, const SimplifyOptions& options) {
  check(options);
  for (FaceId f : mesh.faces())
    if (mesh.degree(f) != 3)
      throw InvalidInput("simplify/polygon", "only triangles can be simplified", describe_face(mesh.soup(), f));
  Simplifier simplifier(mesh, options.evenness);
  simplifier.reduce_to(is_closed(mesh) ? options.faces / 2 * 2 : options.faces);
  simplifier.even_out(kEveningRounds, options.keep_sharp);
  return simplifier.result().soup;
}

std::optional<PolygonSoup> simplified_alike(const Mesh& mesh, const MirrorPlane& plane,
                                            const SimplifyOptions& options) {
  check(options);
  std::optional<HalfMesh> half = upper_half(mesh, plane);
  if (!half) return {};
  const Mesh upper(half->soup);
  Simplifier simplifier(upper, options.evenness, &plane, half->on_plane);
  simplifier.reduce_to(options.faces / 2);
  simplifier.even_out(kEveningRounds, options.keep_sharp);
  return with_image(simplifier.result(), plane);
}

PolygonSoup triangulated(const PolygonSoup& soup) {
  PolygonSoup result;
  result.points = soup.points;
  for (int f = 0; f < soup.num_faces(); ++f)
    for (const auto& triangle : triangulate_face(soup, f)) result.add_face(triangle);
  return result;
}

namespace {

double farthest_vertex(const PolygonSoup& from, const PolygonSoup& to) {
  const SurfaceDistance distance(to);
  std::vector<char> used(from.points.size(), 0);
  for (int v : from.corners) used[v] = 1;
  double farthest = 0;
  for (int v = 0; v < from.num_points(); ++v) {
    if (!used[v]) continue;
    farthest = std::max(farthest, distance(from.points[v]));
  }
  return farthest;
}

}  // namespace

double vertex_distance(const PolygonSoup& a, const PolygonSoup& b) {
  const PolygonSoup s = triangulated(a), t = triangulated(b);
  return std::max(farthest_vertex(s, t), farthest_vertex(t, s));
}

}  // namespace plico
