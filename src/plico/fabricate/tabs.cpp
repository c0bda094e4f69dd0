#include "plico/fabricate/tabs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plico/base/error.h"
#include "plico/fabricate/pieces.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

// A trapezoid over a base of some length: slanted at the two ends by these angles, this deep.
struct Trapezoid {
  double angle_a, angle_b, depth;
};

constexpr double kClearance = 0.3;           // millimetres between a tip and whatever is beyond it
constexpr double kSpread = radians(3);       // between a slanted side and whatever is beside it
constexpr double kLeastDepth = 1.5;          // millimetres; a shallower tab holds nothing
constexpr double kLeastAngle = radians(12);  // a flatter slant leaves no tip
constexpr double kSlightlySmaller = 0.6;     // of the full depth: down to here before the other side is tried
constexpr double kDepths[] = {1, 0.85, 0.7, 0.6, 0.5, 0.4, 0.3};
constexpr double kAngles[] = {1, 0.7, 0.45};

double slope(double angle) { return 1 / std::tan(angle); }

// Points above the base from a to b, `out` being its unit normal on the side of the tab.
std::array<Vec2, 4> raise(const Vec2& a, const Vec2& b, const Vec2& out, const Trapezoid& t) {
  const Vec2 along = (b - a).normalized();
  return {a, b, b + out * t.depth - along * (t.depth * slope(t.angle_b)),
          a + out * t.depth + along * (t.depth * slope(t.angle_a))};
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

  // Adds the largest tab that fits on `e`, at least `least` of the full depth.
  bool try_edge(int e, double least) {
    const double base = length(e);
    bool first_try = true;
    for (double angle_factor : kAngles) {
      for (double depth_factor : kDepths) {
        if (depth_factor < least) break;
        const std::optional<Trapezoid> t = trapezoid(e, base, angle_factor, depth_factor);
        if (t && fits(e, *t)) {
          add(e, *t);
          const bool full = first_try && t->depth >= 0.999 * options_.depth &&
                            std::min(t->angle_a, t->angle_b) >= 0.999 * options_.angle;
          ++(full ? result_.full : result_.shrunk);
          return true;
        }
        first_try = false;
      }
    }
    return false;
  }

  // Slanted no steeper than the corners of the panel it is glued under; at least a fifth of the base is left as tip.
  std::optional<Trapezoid> trapezoid(int e, double base, double angle_factor, double depth_factor) const {
    const PanelSide under = sides_.side(net_.mate[e]);
    const double most = options_.angle * angle_factor;
    const auto angle = [&](double corner) { return std::min(most, corner - kSpread); };
    Trapezoid t{angle(corner_angle(under.panel, under.side + 1)), angle(corner_angle(under.panel, under.side)), 0};
    if (std::min(t.angle_a, t.angle_b) < kLeastAngle) return std::nullopt;
    const double highest = 0.8 * base / (slope(t.angle_a) + slope(t.angle_b));
    t.depth = std::min(options_.depth, highest) * depth_factor;
    if (t.depth < kLeastDepth) return std::nullopt;
    return t;
  }

  double corner_angle(int panel, int i) const {
    const auto& face = net_.sheet.faces[panel];
    const std::size_t n = face.size(), at = static_cast<std::size_t>(i) % n;
    const Vec2& p = net_.sheet.vertices[face[at]];
    const Vec2 in = net_.sheet.vertices[face[(at + n - 1) % n]] - p, out = net_.sheet.vertices[face[(at + 1) % n]] - p;
    const double angle = std::atan2(cross(out, in), out.dot(in));
    return angle < 0 ? angle + 2 * kPi : angle;
  }

  // The same trapezoid a little larger; what is free of this is clear of the tab.
  static Trapezoid grown(const Trapezoid& t) {
    return {t.angle_a + kSpread, t.angle_b + kSpread, t.depth + kClearance};
  }

  bool fits(int e, const Trapezoid& t) const {
    const PanelSide s = sides_.side(e), under = sides_.side(net_.mate[e]);
    const auto outside = raised(s, t, true);
    const std::array<Vec2, 4> shape{outside[1], outside[0], outside[3], outside[2]};  // counter-clockwise
    if (taken_.overlaps(shape, net_.part[s.panel])) return false;
    const Vec2 a = sides_.to(under), b = sides_.from(under);  // a meets a, b meets b
    Vec2 in = perpendicular((a - b).normalized());
    auto turned_over = raise(a, b, in, {t.angle_a, t.angle_b, t.depth + kClearance});
    std::ranges::reverse(turned_over);
    return contains(polygon(net_.sheet, under.panel), turned_over);
  }

  std::array<Vec2, 4> raised(PanelSide s, const Trapezoid& t, bool with_clearance) const {
    const Vec2 a = sides_.from(s), b = sides_.to(s);
    return raise(a, b, -perpendicular((b - a).normalized()), with_clearance ? grown(t) : t);
  }

  void add(int e, const Trapezoid& t) {
    const PanelSide s = sides_.side(e);
    const std::array<Vec2, 4> c = raised(s, t, false);
    result_.tabs.push_back({e, net_.mate[e], c});
    taken_.add({c[1], c[0], c[3], c[2]}, net_.part[s.panel]);
  }

  const NetSides& sides_;
  const Unfolding& net_;
  const TabOptions& options_;
  PieceGrid taken_;
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
