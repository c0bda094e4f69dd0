#include "plico/origami/drawing_symmetry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "plico/base/libm.h"

namespace plico {
namespace {

constexpr int kMostCandidates = 200;  // more vertices than this at one distance: a circle of creases, not a polygon
constexpr double kSameAngle = 1e-6;   // radians

Vec2 centre_of(const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : points) sum += p;
  return sum / static_cast<double>(std::max<std::size_t>(1, points.size()));
}

Eigen::Matrix2d turn_between(const Vec2& from, const Vec2& to, bool reflect) {
  const double scale = from.norm() * to.norm();
  const double c = (reflect ? from.x() * to.x() - from.y() * to.y() : from.dot(to)) / scale;
  const double s = (reflect ? from.x() * to.y() + from.y() * to.x() : cross(from, to)) / scale;
  Eigen::Matrix2d turn;
  if (reflect)
    turn << c, s, s, -c;
  else
    turn << c, -s, s, c;
  return turn;
}

// Nearest vertex within a distance, by cells of that size.
class NearestVertex {
 public:
  NearestVertex(const std::vector<Vec2>& points, double off) : points_(points), off_(off) {
    for (int v = 0; v < static_cast<int>(points.size()); ++v) cells_.emplace(cell(points[v]), v);
  }
  int operator()(const Vec2& p) const {
    const Cell at = cell(p);
    int best = -1;
    double best_distance = off_;
    for (long i = at.first - 1; i <= at.first + 1; ++i)
      for (long j = at.second - 1; j <= at.second + 1; ++j)
        for (auto [it, end] = cells_.equal_range({i, j}); it != end; ++it) {
          const double distance = (points_[it->second] - p).norm();
          if (distance > best_distance) continue;
          best = it->second;
          best_distance = distance;
        }
    return best;
  }

 private:
  using Cell = std::pair<long, long>;
  Cell cell(const Vec2& p) const { return {std::lround(p.x() / off_), std::lround(p.y() / off_)}; }

  const std::vector<Vec2>& points_;
  double off_;
  std::multimap<Cell, int> cells_;
};

class SymmetrySearch {
 public:
  SymmetrySearch(const CreasePattern& sheet, double off)
      : sheet_(sheet), off_(off), centre_(centre_of(sheet.vertices)), nearest_(sheet.vertices, off) {
    for (int e = 0; e < sheet.num_edges(); ++e) edge_[std::minmax(sheet.edges[e].a, sheet.edges[e].b)] = e;
  }

  std::vector<DrawingSymmetry> run() const {
    DrawingSymmetry identity{Eigen::Matrix2d::Identity(), std::vector<int>(sheet_.vertices.size())};
    std::iota(identity.vertex.begin(), identity.vertex.end(), 0);
    std::vector<DrawingSymmetry> group = {std::move(identity)};
    for (const Eigen::Matrix2d& turn : candidates()) {
      DrawingSymmetry found{turn, images(turn)};
      const auto is_known = [&](const DrawingSymmetry& s) { return s.vertex == found.vertex; };
      if (!found.vertex.empty() && keeps_edges(found.vertex) && std::none_of(group.begin(), group.end(), is_known))
        group.push_back(std::move(found));
    }
    if (!is_closed(group)) group.resize(1);
    return group;
  }

 private:
  // Those that take the farthest vertex to one as far.
  std::vector<Eigen::Matrix2d> candidates() const {
    std::vector<Eigen::Matrix2d> result;
    const auto radius = [&](const Vec2& p) { return (p - centre_).norm(); };
    const auto far = std::max_element(sheet_.vertices.begin(), sheet_.vertices.end(),
                                      [&](const Vec2& p, const Vec2& q) { return radius(p) < radius(q); });
    if (far == sheet_.vertices.end() || radius(*far) <= off_) return result;
    for (const Vec2& p : sheet_.vertices) {
      if (std::abs(radius(p) - radius(*far)) > 2 * off_) continue;
      for (bool reflect : {false, true}) result.push_back(turn_between(*far - centre_, p - centre_, reflect));
      if (static_cast<int>(result.size()) > kMostCandidates) return {};
    }
    return result;
  }

  // Empty when some vertex has no image, or two have one.
  std::vector<int> images(const Eigen::Matrix2d& turn) const {
    std::vector<int> image;
    std::vector<char> taken(sheet_.vertices.size(), 0);
    for (const Vec2& p : sheet_.vertices) {
      const int v = nearest_(centre_ + turn * (p - centre_));
      if (v < 0 || taken[v]) return {};
      taken[v] = 1;
      image.push_back(v);
    }
    return image;
  }

  bool keeps_edges(const std::vector<int>& image) const {
    return std::all_of(sheet_.edges.begin(), sheet_.edges.end(), [&](const Crease& e) {
      const auto found = edge_.find(std::minmax(image[e.a], image[e.b]));
      if (found == edge_.end()) return false;
      const Crease& f = sheet_.edges[found->second];
      return f.assignment == e.assignment && std::abs(f.fold_angle - e.fold_angle) < kSameAngle;
    });
  }

  static bool is_closed(const std::vector<DrawingSymmetry>& group) {
    for (const DrawingSymmetry& a : group)
      for (const DrawingSymmetry& b : group) {
        std::vector<int> both;
        for (int v : b.vertex) both.push_back(a.vertex[v]);
        if (std::none_of(group.begin(), group.end(), [&](const DrawingSymmetry& s) { return s.vertex == both; }))
          return false;
      }
    return true;
  }

  const CreasePattern& sheet_;
  double off_;
  Vec2 centre_;
  NearestVertex nearest_;
  std::map<std::pair<int, int>, int> edge_;
};

// The nearest multiple of a full turn by the order of the group, about an axis that its reflections agree on: measured
// turns are as inexact as the drawing.
std::vector<Eigen::Matrix2d> exact_turns(const std::vector<DrawingSymmetry>& group) {
  const auto rotations =
      std::count_if(group.begin(), group.end(), [](const auto& s) { return s.turn.determinant() > 0; });
  const double unit = 2 * kPi / static_cast<double>(rotations);
  const auto angle = [](const DrawingSymmetry& s) { return plico::atan2(s.turn(1, 0), s.turn(0, 0)); };
  double axis = 0;  // twice the direction of an axis, the mean over all, each within half a unit of the first
  int axes = 0;
  double first = 0;
  for (const DrawingSymmetry& s : group) {
    if (s.turn.determinant() > 0) continue;
    if (axes++ == 0) first = angle(s);
    axis += std::remainder(angle(s) - first, unit);
  }
  if (axes > 0) axis = first + axis / axes;
  std::vector<Eigen::Matrix2d> turns;
  for (const DrawingSymmetry& s : group) {
    const bool reflects = s.turn.determinant() < 0;
    const double zero = reflects ? axis : 0, exact = zero + unit * std::round((angle(s) - zero) / unit);
    turns.push_back(turn_between(Vec2(1, 0), Vec2(plico::cos(exact), plico::sin(exact)), reflects));
  }
  return turns;
}

}  // namespace

std::vector<DrawingSymmetry> drawing_symmetries(const CreasePattern& sheet, double off) {
  std::vector<DrawingSymmetry> group = SymmetrySearch(sheet, off).run();
  const std::vector<Eigen::Matrix2d> turns = exact_turns(group);
  for (std::size_t i = 0; i < group.size(); ++i) group[i].turn = turns[i];
  return group;
}

std::vector<Vec2> symmetrized(const std::vector<Vec2>& vertices, const std::vector<DrawingSymmetry>& group) {
  const Vec2 centre = centre_of(vertices);
  std::vector<Vec2> result(vertices.size(), Vec2::Zero());
  for (const DrawingSymmetry& s : group)
    for (std::size_t v = 0; v < vertices.size(); ++v) result[s.vertex[v]] += s.turn * (vertices[v] - centre);
  for (Vec2& p : result) p = centre + p / static_cast<double>(group.size());
  return result;
}

}  // namespace plico
