#include "plico/verify/flat_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace plico {
namespace {

constexpr double kFlatFolds = 1e-6;   // radians: of a goal that is flat
constexpr double kShortPiece = 1e-4;  // of the mean side: what a drawing may be off by
constexpr double kAside = 1e-3;       // of a piece: how far beside it the stacks are looked at

struct FoldedSide {
  int panel, edge;
  Vec2 from, to;  // folded
};

// The plane's motion that takes a panel to its folded place.
struct FlatPlacement {
  bool known = false, turned = false;
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Vec2 shift = Vec2::Zero();

  Vec2 operator()(const Vec2& p) const { return linear * p + shift; }
};

FlatPlacement reflected(const FlatPlacement& placement, const Vec2& a, const Vec2& b) {
  const Vec2 along = (b - a).normalized();
  const Eigen::Matrix2d mirror = 2 * along * along.transpose() - Eigen::Matrix2d::Identity();
  FlatPlacement result;
  result.known = true;
  result.turned = !placement.turned;
  result.linear = placement.linear * mirror;
  result.shift = placement(a - mirror * a);
  return result;
}

bool contains(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

double distance_to(const FoldedSide& side, const Vec2& p) {
  const Vec2 along = side.to - side.from;
  const double share = std::clamp(along.dot(p - side.from) / along.squaredNorm(), 0.0, 1.0);
  return (side.from + share * along - p).norm();
}

class LayerJudge {
 public:
  LayerJudge(const CreasePattern& sheet, const std::vector<FaceOrder>& orders)
      : sheet_(sheet), beside_(edge_sides(sheet)), placements_(sheet.faces.size()) {
    for (int e = 0; e < sheet.num_edges(); ++e) edge_between_[std::minmax(sheet.edges[e].a, sheet.edges[e].b)] = e;
    for (const FaceOrder& order : orders) side_[{order.f, order.g}] = order.side;
    for (int f = 0; f < sheet.num_faces(); ++f)
      if (!placements_[f].known) place_from(f);
    collect_sides();
  }

  FlatLayersVerdict run() {
    for (const Crease& crease : sheet_.edges)
      if (std::abs(crease.fold_angle) > kFlatFolds && std::abs(std::abs(crease.fold_angle) - kPi) > kFlatFolds) {
        verdict_.flat_goal = false;
        fail("the goal is not flat", {}, sheet_.vertices[crease.a]);
        return verdict_;
      }
    for (const FoldedSide& side : sides_)
      if (!look_along(side)) return verdict_;
    verdict_.valid = true;
    return verdict_;
  }

 private:
  bool is_folded(int edge) const { return std::abs(sheet_.edges[edge].fold_angle) > kFlatFolds; }

  int neighbour(int panel, int edge) const {
    const EdgeSides& sides = beside_[edge];
    if (!is_hinge(sheet_.edges[edge], sides)) return -1;
    return sides.left == panel ? sides.right : sides.left;
  }

  void place_from(int root) {
    placements_[root].known = true;
    std::vector<int> open{root};
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      const std::vector<int>& face = sheet_.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const int a = face[i], b = face[(i + 1) % face.size()], e = edge_between_.at(std::minmax(a, b));
        const int g = neighbour(f, e);
        if (g < 0 || placements_[g].known) continue;
        placements_[g] =
            is_folded(e) ? reflected(placements_[f], sheet_.vertices[a], sheet_.vertices[b]) : placements_[f];
        open.push_back(g);
      }
    }
  }

  void collect_sides() {
    double length = 0;
    part_ = parts_of(sheet_);
    for (int f = 0; f < sheet_.num_faces(); ++f) {
      std::vector<Vec2>& outline = outlines_.emplace_back();
      for (int v : sheet_.faces[f]) outline.push_back(placements_[f](sheet_.vertices[v]));
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        sides_.push_back(
            {f, edge_between_.at(std::minmax(sheet_.faces[f][i], sheet_.faces[f][next])), outline[i], outline[next]});
        length += (outline[next] - outline[i]).norm();
      }
    }
    off_ = sides_.empty() ? 0 : kShortPiece * length / static_cast<double>(sides_.size());
  }

  // Where along `side`, from 0 to 1, others cross it or end on it.
  std::vector<double> cuts(const FoldedSide& side) const {
    std::vector<double> at{0, 1};
    const Vec2 along = side.to - side.from;
    for (const FoldedSide& other : sides_) {
      if (part_[other.panel] != part_[side.panel]) continue;
      const Vec2 across = other.to - other.from;
      const double turn = cross(along, across);
      if (std::abs(turn) > 1e-9 * along.norm() * across.norm()) {
        const double share = cross(Vec2(other.from - side.from), across) / turn;
        if (share > 0 && share < 1 && distance_to(other, side.from + share * along) <= off_) at.push_back(share);
      }
      for (const Vec2& end : {other.from, other.to})
        if (const double share = along.dot(end - side.from) / along.squaredNorm();
            share > 0 && share < 1 && distance_to(side, end) <= off_)
          at.push_back(share);
    }
    std::sort(at.begin(), at.end());
    return at;
  }

  bool look_along(const FoldedSide& side) {
    const std::vector<double> at = cuts(side);
    const Vec2 along = side.to - side.from;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      const double length = (at[i + 1] - at[i]) * along.norm();
      if (length <= 10 * off_) continue;
      const Vec2 middle = side.from + (at[i] + at[i + 1]) / 2 * along;
      const Vec2 aside = std::max(kAside * length, 2 * off_) * Vec2(-along.y(), along.x()).normalized();
      ++verdict_.places;
      if (!look_at(side.panel, middle, aside)) return false;
    }
    return true;
  }

  bool look_at(int panel, const Vec2& middle, const Vec2& aside) {
    const auto left = stack_at(middle + aside, panel), right = stack_at(middle - aside, panel);
    if (!left || !right) return false;
    return goes_on(*left, *right, middle) && folds_back(*left, *right, middle) && folds_back(*right, *left, middle);
  }

  // The panels there, lowest first; nothing when two have no order, or three go in a circle.
  std::optional<std::vector<int>> stack_at(const Vec2& place, int panel) {
    std::vector<int> there;
    for (int f = 0; f < sheet_.num_faces(); ++f)
      if (part_[f] == part_[panel] && contains(outlines_[f], place)) there.push_back(f);
    std::vector<int> stack(there.size(), -1);
    for (int f : there) {
      std::size_t below = 0;
      for (int g : there) {
        if (f == g) continue;
        const int order = is_above(f, g);
        if (order == 0) return fail("two panels that lie on each other have no order", {f, g}, place), std::nullopt;
        below += order > 0;
      }
      if (stack[below] >= 0)
        return fail("panels lie on each other in a circle", {stack[below], f}, place), std::nullopt;
      stack[below] = f;
    }
    return stack;
  }

  // 1: f is above g, -1: below, 0: not said.
  int is_above(int f, int g) const {
    if (const auto said = side_.find({f, g}); said != side_.end())
      return said->second * (placements_[g].turned ? -1 : 1);
    if (const auto said = side_.find({g, f}); said != side_.end())
      return -said->second * (placements_[f].turned ? -1 : 1);
    return 0;
  }

  // The panel that a panel of one stack becomes in the other: itself, or that beyond a flat crease; -1: none.
  int beyond(int panel, const std::vector<int>& other, const Vec2& middle) const {
    if (std::find(other.begin(), other.end(), panel) != other.end()) return panel;
    const int edge = edge_at(panel, middle);
    const int next = edge < 0 ? -1 : neighbour(panel, edge);
    return next >= 0 && std::find(other.begin(), other.end(), next) != other.end() ? next : -1;
  }

  int edge_at(int panel, const Vec2& middle) const {
    int nearest = -1;
    double least = 3 * off_;
    for (const FoldedSide& side : sides_)
      if (side.panel == panel && distance_to(side, middle) < least) {
        least = distance_to(side, middle);
        nearest = side.edge;
      }
    return nearest;
  }

  bool goes_on(const std::vector<int>& left, const std::vector<int>& right, const Vec2& middle) {
    std::ptrdiff_t last = -1;
    int last_panel = -1;
    for (int f : left) {
      const int next = beyond(f, right, middle);
      if (next < 0) continue;
      const std::ptrdiff_t at = std::find(right.begin(), right.end(), next) - right.begin();
      if (at < last) return fail("two panels change places where they go on", {last_panel, f}, middle);
      last = at;
      last_panel = f;
    }
    return true;
  }

  // Position in `stack` of the panel that f folds back to; -1: it goes on, -2: it ends.
  int partner(const std::vector<int>& stack, const std::vector<int>& other, int f, const Vec2& middle) const {
    if (beyond(f, other, middle) >= 0) return -1;
    const int edge = edge_at(f, middle);
    const int next = edge < 0 ? -1 : neighbour(f, edge);
    const auto at = std::find(stack.begin(), stack.end(), next);
    return next < 0 || at == stack.end() ? -2 : static_cast<int>(at - stack.begin());
  }

  bool folds_back(const std::vector<int>& stack, const std::vector<int>& other, const Vec2& middle) {
    std::vector<int> partners;
    for (int f : stack) partners.push_back(partner(stack, other, f, middle));
    for (int i = 0; i < static_cast<int>(stack.size()); ++i) {
      if (partners[i] <= i) continue;
      if (!turns_as_its_letter(stack[i], stack[partners[i]], middle)) return false;
      for (int k = i + 1; k < partners[i]; ++k)
        if (partners[k] == -1 || (partners[k] >= 0 && (partners[k] < i || partners[k] > partners[i])))
          return fail("a fold has paper in it that does not end there", {stack[i], stack[partners[i]], stack[k]},
                      middle);
    }
    return true;
  }

  // A valley brings the fronts together: its upper panel is turned over, its lower one is not.
  bool turns_as_its_letter(int lower, int upper, const Vec2& middle) {
    const int edge = edge_at(lower, middle);
    const bool is_valley = sheet_.edges[edge].fold_angle > 0;
    if (is_valley == (!placements_[lower].turned && placements_[upper].turned)) return true;
    return fail("a fold lies on the other side than its letter says", {lower, upper}, middle);
  }

  bool fail(const char* why, std::vector<int> panels, const Vec2& where) {
    verdict_.why = why;
    verdict_.panels = std::move(panels);
    verdict_.where = where;
    return false;
  }

  const CreasePattern& sheet_;
  std::vector<EdgeSides> beside_;
  std::map<std::pair<int, int>, int> edge_between_;  // of two vertices, the lower first
  std::vector<FlatPlacement> placements_;
  std::vector<int> part_;
  std::vector<std::vector<Vec2>> outlines_;
  std::vector<FoldedSide> sides_;
  std::map<std::pair<int, int>, int> side_;
  double off_ = 0;
  FlatLayersVerdict verdict_;
};

}  // namespace

FlatLayersVerdict check_flat_layers(const CreasePattern& sheet, const std::vector<FaceOrder>& orders) {
  return LayerJudge(sheet, orders).run();
}

}  // namespace plico
