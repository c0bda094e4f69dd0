#include "plico/origami/pattern_check.h"

#include <fmt/format.h>

#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "plico/base/libm.h"
#include "plico/fold/planar_faces.h"
#include "plico/geom/predicates.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

bool is_folded(const Crease& crease) {
  return crease.assignment == Assignment::Mountain || crease.assignment == Assignment::Valley;
}

std::vector<int> edge_of_hinge(const CreasePattern& sheet) {
  std::vector<int> result;
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (hinge[e] >= 0) result.push_back(e);
  return result;
}

double turn(const Vec2& from, const Vec2& to) {  // counter-clockwise, in [0, 2 pi)
  const double angle = plico::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  return angle < 0 ? angle + 2 * kPi : angle;
}

// Sectors between the mountains and valleys: flat creases inside them are passed over.
std::vector<double> folded_sectors(const CreasePattern& sheet, const VertexFacts& facts) {
  std::vector<double> result;
  double before_first = 0;
  for (std::size_t i = 0; i < facts.edges.size(); ++i) {
    if (is_folded(sheet.edges[facts.edges[i]])) result.push_back(0);
    (result.empty() ? before_first : result.back()) += facts.sectors[i];
  }
  if (!result.empty()) result.back() += before_first;
  return result;
}

double kawasaki_defect(const std::vector<double>& sectors) {
  if (sectors.size() % 2 == 1) return 0;
  double every_other = 0;
  for (std::size_t i = 0; i < sectors.size(); i += 2) every_other += sectors[i];
  return sectors.empty() ? 0 : std::abs(every_other - kPi);
}

bool is_flat_folded(const CreasePattern& sheet, const VertexFacts& facts, double tolerance) {
  return facts.mountains + facts.valleys > 0 && std::all_of(facts.edges.begin(), facts.edges.end(), [&](int e) {
           const Crease& crease = sheet.edges[e];
           return !is_folded(crease) || std::abs(crease.fold_angle) > kPi - tolerance;
         });
}

VertexFacts facts_of(const CreasePattern& sheet, const RealVertex& vertex, const std::vector<int>& edge_of,
                     double residual) {
  VertexFacts facts;
  facts.vertex = vertex.vertex;
  facts.residual = residual;
  const std::size_t degree = vertex.hinges.size();
  for (std::size_t i = 0; i < degree; ++i) {
    const int e = facts.edges.emplace_back(edge_of[vertex.hinges[i]]);
    const double sector = turn(vertex.directions[i], vertex.directions[(i + 1) % degree]);
    facts.sectors.push_back(degree == 1 ? 2 * kPi : sector);
    if (sheet.edges[e].assignment == Assignment::Mountain) ++facts.mountains;
    if (sheet.edges[e].assignment == Assignment::Valley) ++facts.valleys;
  }
  facts.flat_folded = is_flat_folded(sheet, facts, 1e-6);
  facts.kawasaki = kawasaki_defect(folded_sectors(sheet, facts));
  return facts;
}

std::string at(const Vec2& p) { return fmt::format("near {:.6g} {:.6g}", p.x(), p.y()); }

class Checker {
 public:
  Checker(const CreasePattern& sheet, const PatternCheckOptions& options) : sheet_(sheet), options_(options) {
    degree_.assign(sheet.vertices.size(), 0);
    on_border_.assign(sheet.vertices.size(), false);
    for (const Crease& edge : sheet.edges)
      for (int v : {edge.a, edge.b}) {
        ++degree_[v];
        if (edge.assignment == Assignment::Boundary || edge.assignment == Assignment::Cut) on_border_[v] = true;
      }
  }

  PatternReport run() {
    check_lengths();
    check_clashes();
    check_same_places();
    if (report_.usable()) {
      check_ends();
      check_goals();
      for (const VertexFacts& facts : vertex_facts(sheet_)) check_vertex(facts);
      check_holes();
    }
    std::stable_sort(report_.problems.begin(), report_.problems.end(),
                     [](const PatternProblem& a, const PatternProblem& b) { return a.severity < b.severity; });
    return std::move(report_);
  }

 private:
  const Vec2& place(int v) const { return sheet_.vertices[v]; }

  void add_edges(Severity severity, const char* code, std::vector<int> edges, const Vec2& where,
                 const std::string& message, const char* suggestion) {
    std::string names;
    for (int e : edges)
      names +=
          fmt::format("{}edge {} (vertices {} {})", names.empty() ? "" : ", ", e, sheet_.edges[e].a, sheet_.edges[e].b);
    report_.problems.push_back(
        {severity, code, message, fmt::format("{} {}", names, at(where)), suggestion, std::move(edges), {}});
  }
  void add_vertex(Severity severity, const char* code, int v, const std::string& message, const char* suggestion) {
    report_.problems.push_back(
        {severity, code, message, fmt::format("vertex {} {}", v, at(place(v))), suggestion, {}, {v}});
  }
  Vec2 middle(int e) const { return (place(sheet_.edges[e].a) + place(sheet_.edges[e].b)) / 2; }

  void check_lengths() {
    for (int e = 0; e < sheet_.num_edges(); ++e)
      if (place(sheet_.edges[e].a) == place(sheet_.edges[e].b))
        add_edges(Severity::Error, "origami/edge-length", {e}, middle(e), fmt::format("edge {} has no length", e),
                  "remove the edge");
  }

  void check_clashes() {
    for (const auto& [e, f] : clashing_edges(sheet_.vertices, sheet_.edges)) check_clash(e, f);
  }

  void check_clash(int e, int f) {
    const Crease &g = sheet_.edges[e], &h = sheet_.edges[f];
    const Vec2 &a = place(g.a), &b = place(g.b), &c = place(h.a), &d = place(h.b);
    const Vec2 meet = meeting_point(sheet_.vertices, g, h);
    const auto sides = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
      return orient2d(p, q, r) * orient2d(p, q, s);
    };
    if (orient2d(a, b, c) == 0 && orient2d(a, b, d) == 0 && meets_along(a, b, c, d)) {
      add_edges(Severity::Error, "origami/overlap", {e, f}, meet,
                fmt::format("edges {} and {} lie on each other", e, f), "keep one of them");
    } else if (sides(a, b, c, d) < 0 && sides(c, d, a, b) < 0) {
      add_edges(Severity::Error, "origami/crossing", {e, f}, meet,
                fmt::format("edges {} and {} cross without a vertex", e, f), "split both edges where they cross");
    } else {
      add_edges(Severity::Error, "origami/t-junction", {e, f}, meet,
                fmt::format("edges {} and {} touch, but not at a vertex of both", e, f),
                "split the edge that the other one ends on");
    }
  }

  // Of edges on one line that clash: do they share more than a point?
  static bool meets_along(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 u = b - a;
    const auto along = [&](const Vec2& p) { return (p - a).dot(u); };
    const double low = std::max(0.0, std::min(along(c), along(d)));
    return low < std::min(u.squaredNorm(), std::max(along(c), along(d)));
  }

  void check_same_places() {
    const double near = options_.place * diagonal(sheet_);
    const auto along = [&](int v) { return place(v).dot(Vec2(0.8, 0.6)); };  // rarely equal in drawings
    std::vector<int> order(sheet_.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int v, int w) { return along(v) < along(w); });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && along(order[j]) - along(order[i]) <= near; ++j)
        check_same_place(std::min(order[i], order[j]), std::max(order[i], order[j]), near);
  }

  void check_same_place(int v, int w, double near) {
    if ((place(v) - place(w)).norm() > near || (on_border_[v] && on_border_[w])) return;  // the two sides of a cut
    add_vertex(Severity::Warning, "origami/duplicate-vertex", v,
               fmt::format("vertices {} and {} lie in one place, so their creases do not join", v, w),
               "make them one vertex");
    report_.problems.back().vertices.push_back(w);
  }

  void check_ends() {
    for (int v = 0; v < sheet_.num_vertices(); ++v)
      if (degree_[v] == 0)
        add_vertex(Severity::Note, "origami/unused-vertex", v, fmt::format("no edge uses vertex {}", v), "");
    const std::vector<EdgeSides> sides = edge_sides(sheet_);
    for (int e = 0; e < sheet_.num_edges(); ++e) {
      if (!is_folded(sheet_.edges[e]) || (sides[e].left >= 0 && sides[e].right >= 0)) continue;
      const bool ends = degree_[sheet_.edges[e].a] == 1 || degree_[sheet_.edges[e].b] == 1;
      const int v = degree_[sheet_.edges[e].b] == 1 ? sheet_.edges[e].b : sheet_.edges[e].a;
      add_edges(
          Severity::Warning, "origami/dangling", {e}, ends ? place(v) : middle(e),
          ends ? fmt::format("crease {} ends inside the sheet at vertex {}, so it cannot fold", e, v)
               : fmt::format("crease {} does not lie between two panels, so it cannot fold", e),
          ends ? "lead the crease on to another one or to the border" : "remove the crease, or make it a boundary");
    }
  }

  void check_goals() {
    for (int e = 0; e < sheet_.num_edges(); ++e) {
      const Assignment assignment = sheet_.edges[e].assignment;
      const double angle = sheet_.edges[e].fold_angle;
      if (!std::isfinite(angle) || std::abs(angle) > kPi + options_.angle) {
        add_edges(Severity::Error, "origami/fold-angle", {e}, middle(e),
                  fmt::format("crease {} has a goal of {:.6g} degrees, must be in [-180, 180]", e, degrees(angle)),
                  "correct the fold angle");
      } else if (is_folded(sheet_.edges[e]) && assignment_of(angle) != assignment) {
        const char* kind = assignment == Assignment::Mountain ? "mountain" : "valley";
        add_edges(angle == 0 ? Severity::Note : Severity::Warning, "origami/assignment", {e}, middle(e),
                  fmt::format("crease {} is a {} with a goal of {:.6g} degrees", e, kind, degrees(angle)),
                  "mountains have negative goals, valleys positive ones");
      }
    }
  }

  void check_vertex(const VertexFacts& facts) {
    if (is_locked(facts)) {
      add_vertex(Severity::Warning, "origami/locked-vertex", facts.vertex,
                 fmt::format("vertex {} has {} creases and cannot fold", facts.vertex, facts.edges.size()),
                 "a vertex inside the sheet needs four creases, or creases in one line");
    } else {
      check_flat_folding(facts);
    }
    if (facts.residual > options_.angle)
      add_vertex(Severity::Warning, "origami/goal-open", facts.vertex,
                 fmt::format("at the goal the sheet tears at vertex {}: it misses closing by {:.4g} degrees",
                             facts.vertex, degrees(facts.residual)),
                 "correct the fold angles of its creases");
  }

  // With up to three creases only two in one line can fold (three rigid sectors of less than pi make a solid corner).
  bool is_locked(const VertexFacts& facts) const {
    const std::size_t n = facts.edges.size();
    if (n > 3) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (std::abs(facts.sectors[i] - kPi) <= options_.angle) return false;
    return true;
  }

  void check_flat_folding(const VertexFacts& facts) {
    const int creases = facts.mountains + facts.valleys;
    if (creases == 0) return;
    const Severity severity = facts.flat_folded ? Severity::Warning : Severity::Note;
    const char* tail = facts.flat_folded ? "" : " (its goal is not flat)";
    if (creases % 2 == 1) {
      add_vertex(severity, "origami/kawasaki", facts.vertex,
                 fmt::format("vertex {} has {} creases, must be even to fold flat{}", facts.vertex, creases, tail),
                 "add or remove a crease");
    } else if (facts.kawasaki > options_.angle) {
      add_vertex(severity, "origami/kawasaki", facts.vertex,
                 fmt::format("every other sector at vertex {} misses 180 degrees by {:.4g}, must be 0 to fold flat{}",
                             facts.vertex, degrees(facts.kawasaki), tail),
                 "move the vertex or turn a crease");
    }
    const int surplus = std::abs(facts.mountains - facts.valleys);
    if (surplus != 2)
      add_vertex(severity, "origami/maekawa", facts.vertex,
                 fmt::format("vertex {} has {} mountains and {} valleys, must differ by 2 to fold flat{}", facts.vertex,
                             facts.mountains, facts.valleys, tail),
                 "make a mountain a valley, or the other way round");
  }

  void check_holes() {
    const std::vector<RealVertex> loops = real_vertices(sheet_);
    const Closure goals = closure(loops, goal(make_linkage(sheet_)));
    for (std::size_t i = 0; i < loops.size(); ++i)
      if (loops[i].is_hole() && goals.residual[i] > options_.angle)
        add_vertex(Severity::Warning, "origami/goal-open", loops[i].vertex,
                   fmt::format("at the goal the sheet tears around the hole at vertex {}: residual {:.4g}",
                               loops[i].vertex, goals.residual[i]),
                   "correct the fold angles of the creases around it");
  }

  const CreasePattern& sheet_;
  const PatternCheckOptions& options_;
  std::vector<int> degree_;  // edges at each vertex
  std::vector<bool> on_border_;
  PatternReport report_;
};

}  // namespace

std::vector<VertexFacts> vertex_facts(const CreasePattern& sheet) {
  const std::vector<RealVertex> vertices = real_vertices(sheet);
  const Closure goals = closure(vertices, goal(make_linkage(sheet)));
  const std::vector<int> edge_of = edge_of_hinge(sheet);
  std::vector<VertexFacts> result;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!vertices[i].is_hole()) result.push_back(facts_of(sheet, vertices[i], edge_of, goals.residual[i]));
  return result;
}

int PatternReport::count(Severity severity) const {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(), [&](const PatternProblem& p) { return p.severity == severity; }));
}

PatternReport check_pattern(const CreasePattern& sheet, const PatternCheckOptions& options) {
  return Checker(sheet, options).run();
}

int num_first_order_motions(const CreasePattern& sheet) {
  const int hinges = make_linkage(sheet).num_hinges();
  std::vector<Eigen::Triplet<double>> entries;
  int rows = 0;
  for (const RealVertex& loop : real_vertices(sheet)) {
    // In the plane, turns about x and y must cancel; around a hole also the lift out of the plane.
    for (std::size_t k = 0; k < loop.hinges.size(); ++k) {
      const Vec2& d = loop.directions[k];
      entries.emplace_back(rows, loop.hinges[k], d.x());
      entries.emplace_back(rows + 1, loop.hinges[k], d.y());
      if (loop.is_hole()) {
        const Vec2& p = loop.points[k];
        entries.emplace_back(rows + 2, loop.hinges[k], p.x() * d.y() - p.y() * d.x());
      }
    }
    rows += loop.is_hole() ? 3 : 2;
  }
  if (rows == 0) return hinges;
  Eigen::SparseMatrix<double> equations(rows, hinges);
  equations.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> qr(equations);
  return hinges - static_cast<int>(qr.rank());
}

}  // namespace plico
