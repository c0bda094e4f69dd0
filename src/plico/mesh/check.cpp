#include "plico/mesh/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "plico/base/disjoint_sets.h"
#include "plico/base/error.h"
#include "plico/geom/predicates.h"
#include "plico/mesh/face_sides.h"
#include "plico/mesh/self_intersections.h"
#include "plico/mesh/triangulate.h"
#include "plico/mesh/weld.h"

namespace plico {
namespace {

const char* const kRepair = "plico check --repair";

double size_of(const PolygonSoup& soup, int face) {  // greatest distance from the first corner
  double size = 0;
  for (int v : soup.face(face)) size = std::max(size, (soup.points[v] - soup.points[soup.face(face)[0]]).norm());
  return size;
}

std::string coordinates(const Vec3& p) { return fmt::format("{:.6g} {:.6g} {:.6g}", p.x(), p.y(), p.z()); }

bool same_side(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q) {
  return orient2d(a, b, p) * orient2d(a, b, q) > 0;
}

bool sides_cross(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  if (same_side(p, q, a, b) || same_side(a, b, p, q)) return false;
  const Eigen::AlignedBox2d s(p.cwiseMin(q), p.cwiseMax(q)), t(a.cwiseMin(b), a.cwiseMax(b));
  return s.intersects(t);
}

class Checker {
 public:
  Checker(const PolygonSoup& soup, const CheckOptions& options) : soup_(soup), options_(options) {}

  CheckReport run() {
    if (check_size()) {
      check_points();
      check_faces();
      check_duplicate_faces();
      check_edges();
      check_fans();
      check_components();
      check_points_used();
      if (options_.self_intersections) check_self_intersections();
    }
    std::stable_sort(report_.problems.begin(), report_.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.severity < b.severity; });
    return std::move(report_);
  }

 private:
  Problem& add(Severity severity, const std::string& code, const std::string& message,
               const std::string& suggestion = {}) {
    report_.problems.push_back({severity, code, message, {}, suggestion, {}, {}});
    return report_.problems.back();
  }
  void add_face(Severity severity, const std::string& code, int f, const std::string& message,
                const std::string& suggestion = {}) {
    Problem& problem = add(severity, code, message, suggestion);
    problem.faces = {f};
    problem.where = in_range(f) ? describe_face(soup_, f) : fmt::format("face {} (vertices {})", f, corners(f));
  }
  void add_vertex(Severity severity, const std::string& code, int v, const std::string& message,
                  const std::string& suggestion = {}) {
    Problem& problem = add(severity, code, message, suggestion);
    problem.vertices = {v};
    problem.where = describe_vertex(soup_, v);
  }
  void add_edge(const std::string& code, std::span<const FaceSide> sides, const std::string& message) {
    Problem& problem = add(Severity::Error, code, message, kRepair);
    for (const FaceSide& side : sides) problem.faces.push_back(side.face);
    problem.vertices = {sides[0].low, sides[0].high};
    problem.where = describe_edge(soup_, sides[0].low, sides[0].high);
  }

  std::string corners(int f) const {
    const auto face = soup_.face(f);
    return fmt::format("{}", fmt::join(face.begin(), face.end(), " "));
  }
  bool in_range(int f) const {
    const auto face = soup_.face(f);
    return !face.empty() &&
           std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < soup_.num_points(); });
  }
  bool good_point(int v) const { return (soup_.points[v].array().abs() <= options_.max_coordinate).all(); }

  bool check_size() {
    if (soup_.num_faces() == 0)
      add(Severity::Error, "mesh/empty", fmt::format("{} vertices but no faces", soup_.num_points()));
    if (soup_.num_faces() > options_.max_faces)
      add(Severity::Error, "mesh/too-many-faces",
          fmt::format("{} faces, must be at most {}", soup_.num_faces(), options_.max_faces));
    return report_.problems.empty();
  }

  void check_points() {
    for (int v = 0; v < soup_.num_points(); ++v) {
      const Vec3& p = soup_.points[v];
      if (!p.allFinite()) {
        add_vertex(Severity::Error, "mesh/not-a-number", v,
                   fmt::format("vertex {} has coordinates {}, must be finite", v, coordinates(p)), kRepair);
      } else if (!good_point(v)) {
        add_vertex(Severity::Error, "mesh/huge", v,
                   fmt::format("vertex {} has coordinates {}, must be at most {:g}", v, coordinates(p),
                               options_.max_coordinate),
                   kRepair);
      }
    }
  }

  void check_faces() {
    sound_.assign(static_cast<std::size_t>(soup_.num_faces()), 0);
    for (int f = 0; f < soup_.num_faces(); ++f) sound_[f] = check_face(f);
  }

  bool check_face(int f) {
    const auto face = soup_.face(f);
    for (int v : face) {
      if (v >= 0 && v < soup_.num_points()) continue;
      add_face(Severity::Error, "mesh/index", f,
               fmt::format("face {} uses vertex {}, must be in [0, {}]", f, v, soup_.num_points() - 1), kRepair);
      return false;
    }
    if (face.size() < 3) {
      add_face(Severity::Error, "mesh/face-size", f,
               fmt::format("face {} has {} corners, at least 3 are needed", f, face.size()), kRepair);
      return false;
    }
    std::vector<int> sorted(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) {
      add_face(Severity::Error, "mesh/repeated-vertex", f,
               fmt::format("face {} uses vertex {} twice ({})", f, *twice, corners(f)), kRepair);
      return false;
    }
    if (!std::all_of(face.begin(), face.end(), [&](int v) { return good_point(v); }))
      return false;  // said by check_points
    return check_shape(f);
  }

  bool check_shape(int f) {
    if (is_degenerate(soup_, f)) {
      add_face(Severity::Error, "mesh/degenerate", f, fmt::format("face {} has no area ({})", f, corners(f)), kRepair);
      return false;
    }
    if (soup_.face(f).size() == 3) return true;
    if (crosses_itself(soup_, f))
      add_face(Severity::Error, "mesh/not-simple", f, fmt::format("the outline of face {} crosses itself", f), kRepair);
    const double off = warp(soup_, f);
    if (off > options_.planarity)
      add_face(Severity::Error, "mesh/not-planar", f,
               fmt::format("face {} is not flat: {:.2g} of its size off its plane, at most {:g}", f, off,
                           options_.planarity),
               kRepair);
    return true;
  }

  void check_duplicate_faces() {
    std::map<std::vector<int>, int> seen;
    for (int f = 0; f < soup_.num_faces(); ++f) {
      if (!sound_[f]) continue;
      std::vector<int> key(soup_.face(f).begin(), soup_.face(f).end());
      std::sort(key.begin(), key.end());
      const auto [first, is_new] = seen.try_emplace(std::move(key), f);
      if (is_new) continue;
      add_face(Severity::Error, "mesh/duplicate-face", f,
               fmt::format("face {} has the same vertices as face {}", f, first->second), kRepair);
      report_.problems.back().faces.push_back(first->second);
      sound_[f] = 0;
    }
  }

  void check_edges() {
    FaceSides(soup_, sound_).for_each_edge([&](std::span<const FaceSide> sides) {
      if (sides.size() == 1) ++open_edges_;
      const int a = sides[0].low, b = sides[0].high;
      if (sides.size() > 2)
        add_edge("mesh/edge-faces", sides,
                 fmt::format("edge {}-{} has {} faces, at most 2 can unfold", a, b, sides.size()));
      if (sides.size() == 2 && sides[0].forward == sides[1].forward)
        add_edge("mesh/orientation", sides,
                 fmt::format("faces {} and {} run along edge {}-{} in the same direction", sides[0].face, sides[1].face,
                             a, b));
    });
  }

  // The corners at a vertex, joined across shared sides, must be one group.
  void check_fans() {
    DisjointSets fans(soup_.corners.size());
    FaceSides(soup_, sound_).for_each_edge([&](std::span<const FaceSide> sides) {
      for (std::size_t i = 1; i < sides.size(); ++i) {
        const FaceSide &s = sides[0], &t = sides[i];
        const bool opposite = s.forward != t.forward;
        fans.join(s.corner, opposite ? t.next : t.corner);
        fans.join(s.next, opposite ? t.corner : t.next);
      }
    });
    std::vector<int> first(soup_.points.size(), -1), others(soup_.points.size(), 0);
    for (int f = 0; f < soup_.num_faces(); ++f)
      for (int c = soup_.offsets[f]; sound_[f] && c < soup_.offsets[f + 1]; ++c) {
        if (fans.find(c) != c) continue;
        first[soup_.corners[c]] < 0 ? first[soup_.corners[c]] = c : ++others[soup_.corners[c]];
      }
    for (int v = 0; v < soup_.num_points(); ++v)
      if (others[v] > 0)
        add_vertex(Severity::Error, "mesh/bow-tie", v,
                   fmt::format("the faces around vertex {} make {} fans, must make one", v, others[v] + 1), kRepair);
  }

  void check_components() {
    DisjointSets parts(static_cast<std::size_t>(soup_.num_faces()));
    std::vector<char> open(static_cast<std::size_t>(soup_.num_faces()), 0);
    FaceSides(soup_, sound_).for_each_edge([&](std::span<const FaceSide> sides) {
      for (std::size_t i = 1; i < sides.size(); ++i) parts.join(sides[0].face, sides[i].face);
      // Neither open nor inconsistent components have an inside.
      if (sides.size() != 2 || sides[0].forward == sides[1].forward) open[sides[0].face] = 1;
    });
    std::map<int, double> volume;
    std::map<int, bool> closed;
    for (int f = 0; f < soup_.num_faces(); ++f) {
      if (!sound_[f]) continue;
      const int part = parts.find(f);
      const auto is_closed = closed.try_emplace(part, true).first;
      if (open[f]) is_closed->second = false;
      const Vec3 arm = soup_.points[soup_.face(f)[0]] - soup_.points[soup_.face(part)[0]];
      volume[part] += arm.dot(twice_vector_area(soup_, f)) / 6;
    }
    for (const auto& [part, v] : volume)
      if (closed[part] && v < 0)
        add_face(Severity::Warning, "mesh/inside-out", part,
                 fmt::format("the component of face {} is inside out (volume {:.4g}); its mountains would be valleys",
                             part, v),
                 kRepair);
    if (volume.size() > 1)
      add(Severity::Note, "mesh/components", fmt::format("{} components, each gets its own part", volume.size()));
    if (open_edges_ > 0)
      add(Severity::Note, "mesh/open", fmt::format("the surface is open: {} boundary edges", open_edges_));
  }

  void check_points_used() {
    const std::vector<int> first = welded_points(soup_.points);
    std::vector<char> used(soup_.points.size(), 0);
    for (int v : soup_.corners)
      if (v >= 0 && v < soup_.num_points()) used[v] = 1;
    for (int v = 0; v < soup_.num_points(); ++v) {
      if (!used[v]) {
        add_vertex(Severity::Note, "mesh/unused-vertex", v, fmt::format("vertex {} belongs to no face", v), kRepair);
      } else if (first[v] != v) {
        add_vertex(Severity::Warning, "mesh/duplicate-vertex", v,
                   fmt::format("vertices {} and {} have the same coordinates; faces are not joined there", first[v], v),
                   kRepair);
        report_.problems.back().vertices = {v, first[v]};
      }
    }
  }

  void check_self_intersections() {
    for (const auto& [f, g] : self_intersections(soup_)) {
      if (!sound_[f] || !sound_[g]) continue;
      add_face(Severity::Warning, "mesh/self-intersection", f,
               fmt::format("faces {} and {} run through each other; a net is possible, the folded shape is not", f, g));
      report_.problems.back().faces = {f, g};
    }
  }

  const PolygonSoup& soup_;
  const CheckOptions& options_;
  CheckReport report_;
  std::vector<char> sound_;  // per face: takes part in the checks of edges and vertices
  int open_edges_ = 0;
};

}  // namespace

std::string_view name(Severity severity) {
  constexpr std::string_view kNames[] = {"error", "warning", "note"};
  return kNames[static_cast<int>(severity)];
}

int CheckReport::count(Severity severity) const {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.severity == severity; }));
}

double warp(const PolygonSoup& soup, int face) {
  const auto corners = soup.face(face);
  const Vec3 area = twice_vector_area(soup, face);
  const double size = corners.empty() ? 0 : size_of(soup, face);
  if (size == 0 || area.norm() == 0) return 0;
  const Vec3 n = area.normalized();
  double mean = 0, off = 0;
  for (int v : corners) mean += (soup.points[v] - soup.points[corners[0]]).dot(n) / static_cast<double>(corners.size());
  for (int v : corners) off = std::max(off, std::abs((soup.points[v] - soup.points[corners[0]]).dot(n) - mean));
  return off / size;
}

bool is_degenerate(const PolygonSoup& soup, int face, double least) {
  const double size = size_of(soup, face);
  return !(twice_vector_area(soup, face).norm() > 2 * least * size * size);
}

bool crosses_itself(const PolygonSoup& soup, int face) {
  const std::vector<Vec2> p = projected(soup, face);
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    if (n > 3 && orient2d(a, b, c) == 0 && (a - b).dot(c - b) > 0) return true;  // turns back on itself
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && sides_cross(a, b, p[j], p[(j + 1) % n])) return true;
  }
  return false;
}

CheckReport check_mesh(const PolygonSoup& soup, const CheckOptions& options) {
  require(options.planarity > 0, "planarity", options.planarity, "above 0");
  require(options.max_faces >= 1, "max faces", options.max_faces, "at least 1");
  return Checker(soup, options).run();
}

Mesh require_mesh(PolygonSoup soup, const CheckOptions& options) {
  CheckOptions quick = options;
  quick.self_intersections = false;
  const CheckReport report = check_mesh(soup, quick);
  if (!report.usable()) {
    const Problem& first = report.problems.front();
    throw InvalidInput(first.code, first.message, first.where, first.suggestion);
  }
  return Mesh(std::move(soup));
}

}  // namespace plico
