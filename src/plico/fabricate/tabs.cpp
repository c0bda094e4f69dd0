#include "plico/fabricate/tabs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fabricate/pieces.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

// A trapezoid over an edge: how far its base stays away from the two ends, its slants there, its depth.
struct Trapezoid {
  double inset_a = 0, inset_b = 0;  // millimetres
  double angle_a, angle_b, depth;
};

// How much a tab is made smaller: factors of angle and depth, and parts of the edge left free at its ends.
struct Trim {
  double angle, depth, inset_a, inset_b;
  double size() const { return depth * (1 - inset_a - inset_b) * (0.6 + 0.4 * angle); }
};

constexpr double kClearance = 0.3;           // millimetres between a tip and whatever is beyond it
constexpr double kSpread = radians(3);       // between a slanted side and whatever is beside it
constexpr double kLeastDepth = 1.5;          // millimetres; a shallower tab holds nothing
constexpr double kLeastAngle = radians(12);  // a flatter slant leaves no tip
constexpr double kSlightlySmaller = 0.6;     // of the full depth: down to here before the other side is tried
constexpr double kOffEdge = 1e-9;            // millimetres; points on an edge are rounded to either side of it

// All ways to trim a tab, the least trimmed first.
std::vector<Trim> trims() {
  std::vector<Trim> all;
  for (double depth : {1.0, 0.85, 0.7, 0.6, 0.5, 0.4, 0.3})
    for (double angle : {1.0, 0.7, 0.45})
      for (double inset_a : {0.0, 0.2, 0.4})
        for (double inset_b : {0.0, 0.2, 0.4}) all.push_back({angle, depth, inset_a, inset_b});
  std::ranges::stable_sort(all, std::greater<>(), &Trim::size);
  return all;
}

double slope(double angle) { return 1 / plico::tan(angle); }

// Points above the edge from a to b, `out` being its unit normal on the side of the tab.
std::array<Vec2, 4> raise(const Vec2& a, const Vec2& b, const Vec2& out, const Trapezoid& t) {
  const Vec2 along = (b - a).normalized();
  const Vec2 base_a = t.inset_a > 0 ? Vec2(a + along * t.inset_a) : a;  // the very corner where there is no inset
  const Vec2 base_b = t.inset_b > 0 ? Vec2(b - along * t.inset_b) : b;
  return {base_a, base_b, base_b + out * t.depth - along * (t.depth * slope(t.angle_b)),
          base_a + out * t.depth + along * (t.depth * slope(t.angle_a))};
}

// The same with base points that are no corners moved off the edge, so that rounding puts them inside no panel.
std::array<Vec2, 4> raise_off(const Vec2& a, const Vec2& b, const Vec2& out, const Trapezoid& t) {
  std::array<Vec2, 4> shape = raise(a, b, out, t);
  if (t.inset_a > 0) shape[0] += kOffEdge * out;
  if (t.inset_b > 0) shape[1] += kOffEdge * out;
  return shape;
}

class TabMaker {
 public:
  TabMaker(const NetSides& sides, const TabOptions& options)
      : sides_(sides), net_(sides.net()), options_(options), taken_(std::max(2.0, 1.5 * options.depth)) {
    for (int f = 0; f < net_.sheet.num_faces(); ++f)
      for (auto& piece : convex_pieces(polygon(net_.sheet, f))) taken_.add(std::move(piece), net_.part[f]);
  }

  Tabs run(const std::vector<std::vector<std::vector<int>>>& outlines) {
    if (options_.side == TabSide::None) return {};
    std::vector<int> turn(net_.sheet.num_edges(), -1);  // when the walk around the parts meets an edge
    int walked = 0, seam = 0;
    for (const auto& part : outlines)
      for (const auto& loop : part)
        for (int e : loop) turn[e] = walked++;
    for (const auto& part : outlines)
      for (const auto& loop : part)
        for (int e : loop)
          if (net_.mate[e] >= 0 && turn[e] < turn[net_.mate[e]]) add_seam(e, seam++);
    std::ranges::sort(result_.tabs, {}, &NetTab::edge);
    return std::move(result_);
  }

 private:
  double length(int e) const { return (sides_.to(sides_.side(e)) - sides_.from(sides_.side(e))).norm(); }
  double panel_area(int e) const { return signed_area(polygon(net_.sheet, sides_.side(e).panel)); }

  // The side that the rule prefers for the seam of `first` and its mate.
  int preferred(int first, int seam) const {
    const int second = net_.mate[first];
    switch (options_.side) {
      case TabSide::Second:
        return second;
      case TabSide::Alternate:
        return seam % 2 ? second : first;
      case TabSide::Auto:
        return panel_area(second) < 0.8 * panel_area(first) ? second : first;
      default:
        return first;
    }
  }

  void add_seam(int first, int seam) {
    if (length(first) < options_.shortest_edge) {
      ++result_.short_seams;
      result_.without.push_back(first);
      return;
    }
    ++result_.seams;
    const int e = preferred(first, seam), other = net_.mate[e];
    const bool both = options_.side == TabSide::Both;
    const double least = kLeastDepth / options_.depth;
    bool made = try_edge(e, kSlightlySmaller);
    bool moved = false;
    if (both) made |= try_edge(other, least);
    if (!made) made = moved = !both && try_edge(other, kSlightlySmaller);
    if (!made) made = try_edge(e, least);
    if (!made) made = moved = !both && try_edge(other, least);
    result_.moved += moved;
    if (made) return;
    ++result_.omitted;
    result_.without.push_back(first);
  }

  // Adds the largest tab that fits on `e`, at least `least` of the full size.
  bool try_edge(int e, double least) {
    const double base = length(e);
    for (const Trim& trim : trims_) {
      if (trim.size() < least) break;
      const std::optional<Trapezoid> t = trapezoid(e, base, trim);
      if (!t || !fits(e, *t)) continue;
      add(e, *t);
      const bool full = t->depth >= 0.999 * options_.depth && t->inset_a + t->inset_b == 0 &&
                        std::min(t->angle_a, t->angle_b) >= 0.999 * options_.angle;
      ++(full ? result_.full : result_.shrunk);
      return true;
    }
    return false;
  }

  // Slanted no steeper than the corners of the panel it is glued under; at least a fifth of the base is left as tip.
  std::optional<Trapezoid> trapezoid(int e, double edge, const Trim& trim) const {
    const PanelSide under = sides_.side(net_.mate[e]);
    const double most = options_.angle * trim.angle;
    // Away from the corner its angle does not matter any more.
    const auto angle = [&](double corner, double inset) { return inset > 0 ? most : std::min(most, corner - kSpread); };
    Trapezoid t{trim.inset_a * edge, trim.inset_b * edge,
                angle(corner_angle(under.panel, under.side + 1), trim.inset_a),
                angle(corner_angle(under.panel, under.side), trim.inset_b), 0};
    if (std::min(t.angle_a, t.angle_b) < kLeastAngle) return std::nullopt;
    const double base = edge - t.inset_a - t.inset_b;
    const double highest = 0.8 * base / (slope(t.angle_a) + slope(t.angle_b));
    t.depth = std::min(options_.depth, highest) * trim.depth;
    if (t.depth < kLeastDepth || base < options_.shortest_edge) return std::nullopt;
    return t;
  }

  double corner_angle(int panel, int i) const {
    const auto& face = net_.sheet.faces[panel];
    const std::size_t n = face.size(), at = static_cast<std::size_t>(i) % n;
    const Vec2& p = net_.sheet.vertices[face[at]];
    const Vec2 in = net_.sheet.vertices[face[(at + n - 1) % n]] - p, out = net_.sheet.vertices[face[(at + 1) % n]] - p;
    const double angle = plico::atan2(cross(out, in), out.dot(in));
    return angle < 0 ? angle + 2 * kPi : angle;
  }

  // The same trapezoid a little larger; what is free of this is clear of the tab.
  static Trapezoid grown(const Trapezoid& t) {
    return {t.inset_a, t.inset_b, t.angle_a + kSpread, t.angle_b + kSpread, t.depth + kClearance};
  }

  bool fits(int e, const Trapezoid& t) const {
    const PanelSide s = sides_.side(e), under = sides_.side(net_.mate[e]);
    const Vec2 from = sides_.from(s), to = sides_.to(s);
    const auto outside = raise_off(from, to, -perpendicular((to - from).normalized()), grown(t));
    const std::array<Vec2, 4> shape{outside[1], outside[0], outside[3], outside[2]};  // counter-clockwise
    if (taken_.overlaps(shape, net_.part[s.panel])) return false;
    const Vec2 a = sides_.to(under), b = sides_.from(under);  // a meets a, b meets b
    const Trapezoid deeper{t.inset_a, t.inset_b, t.angle_a, t.angle_b, t.depth + kClearance};
    auto turned_over = raise_off(a, b, perpendicular((a - b).normalized()), deeper);
    std::ranges::reverse(turned_over);
    return contains(polygon(net_.sheet, under.panel), turned_over);
  }

  void add(int e, const Trapezoid& t) {
    const PanelSide s = sides_.side(e);
    const Vec2 from = sides_.from(s), to = sides_.to(s);
    const std::array<Vec2, 4> c = raise(from, to, -perpendicular((to - from).normalized()), t);
    result_.tabs.push_back({e, net_.mate[e], c});
    taken_.add({c[1], c[0], c[3], c[2]}, net_.part[s.panel]);
  }

  const NetSides& sides_;
  const Unfolding& net_;
  const TabOptions& options_;
  PieceGrid taken_;
  const std::vector<Trim> trims_ = trims();
  Tabs result_;
};

}  // namespace

void check(const TabOptions& options) {
  if (!(options.depth >= 1 && options.depth <= 50))
    throw InvalidOption(fmt::format("tab depth = {:g} mm must be in [1, 50] mm", options.depth));
  if (!(options.angle >= radians(20) && options.angle <= radians(80)))
    throw InvalidOption(fmt::format("tab angle = {:g} deg must be in [20, 80] deg", degrees(options.angle)));
  if (!(options.shortest_edge >= 0))
    throw InvalidOption(fmt::format("shortest edge with a tab = {:g} mm must be at least 0", options.shortest_edge));
}

Tabs make_tabs(const NetSides& sides, const std::vector<std::vector<std::vector<int>>>& outlines,
               const TabOptions& options) {
  check(options);
  return TabMaker(sides, options).run(outlines);
}

}  // namespace plico
