#include "plico/fabricate/marks.h"

#include <algorithm>
#include <cmath>

#include "plico/base/libm.h"
#include "plico/fabricate/pieces.h"

namespace plico {
namespace {

constexpr double kSquare = 2.4;  // side, millimetres
constexpr double kStroke = 2.5;  // length, millimetres

// Where along a seam its stroke stands, from the start of its lower edge; neighbours differ, so that they tell apart.
double fraction(int lower_edge) {
  constexpr double kFractions[] = {0.5, 0.36, 0.64};
  return kFractions[lower_edge % 3];
}

const Vec2& corner(const PlacedPanel& panel, int i) {
  return panel.corners[i % static_cast<int>(panel.corners.size())];
}

// A square in the corner of the panel, on its bisector; smaller when the panel is.
void add_square(PlacedPart& part, const PlacedPanel& panel, int i) {
  const int n = static_cast<int>(panel.corners.size());
  const Vec2& at = panel.corners[i];
  const Vec2 out = (corner(panel, i + 1) - at).normalized(), in = (corner(panel, i + n - 1) - at).normalized();
  const double half = plico::atan2(cross(out, in), out.dot(in)) / 2;
  const Vec2 bisector = rotation(half < 0 ? half + kPi : half) * out, across = perpendicular(bisector);
  for (double side = kSquare; side > 0.6; side *= 0.8) {
    const double nearest = side / 2 / std::max(0.2, plico::tan(std::min(std::abs(half), 1.4))) + 0.3;
    const Vec2 a = at + nearest * bisector - side / 2 * across;
    std::vector<Vec2> square{a, a + side * bisector, a + side * (bisector + across), a + side * across};
    std::ranges::reverse(square);
    if (!contains(panel.corners, square) && side > 0.8) continue;
    part.marks.push_back({std::move(square), true});
    return;
  }
}

void add_stroke(PlacedPart& part, const PlacedPanel& panel, int side, double at) {
  const Vec2 &a = panel.corners[side], &b = corner(panel, side + 1);
  const Vec2 in = perpendicular((b - a).normalized());
  const Vec2 foot = a + at * (b - a) + 1e-6 * in;  // rounding must not put it outside
  const Vec2 wide = 0.05 * (b - a).normalized();
  for (double length = kStroke; length > 0.5; length *= 0.7) {
    const Vec2 top = foot + length * in;
    if (!contains(panel.corners, std::vector<Vec2>{foot, foot + wide, top + wide, top}) && length > 0.9) continue;
    part.marks.push_back({{foot, top}, false});
    return;
  }
}

struct Place {
  PlacedPart* part = nullptr;
  const PlacedPanel* panel = nullptr;
  int side = 0;
};

}  // namespace

void add_marks(PageLayout& layout, const NetSides& sides, const std::vector<std::vector<std::vector<int>>>& outlines,
               const MarkOptions& options) {
  const Unfolding& net = sides.net();
  std::vector<Place> place(net.sheet.num_edges());
  for (PlacedPart& part : layout.parts)
    for (const PlacedPanel& panel : part.panels)
      for (int i = 0; i < static_cast<int>(panel.edges.size()); ++i)
        if (!sides.is_fold(panel.edges[i])) place[panel.edges[i]] = {&part, &panel, i};
  if (options.seam) {
    for (int e = 0; e < net.sheet.num_edges(); ++e) {
      if (net.mate[e] < 0 || !place[e].part) continue;
      const double at = fraction(std::min(e, net.mate[e]));
      add_stroke(*place[e].part, *place[e].panel, place[e].side, e < net.mate[e] ? at : 1 - at);
    }
  }
  if (!options.start) return;
  for (const auto& part : outlines) {
    // The longest edge that is followed by its own mate: gluing begins at the vertex between them.
    int best = -1;
    double longest = -1;
    for (const auto& loop : part) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int e = loop[i], next = loop[(i + 1) % loop.size()];
        const double length = (sides.to(sides.side(e)) - sides.from(sides.side(e))).norm();
        const bool zips = net.mate[e] == next;
        if (best < 0 || (zips && length > longest)) best = e, longest = zips ? length : -1;
      }
    }
    if (best < 0 || !place[best].part) continue;
    const Place& p = place[best];
    add_square(*p.part, *p.panel, (p.side + 1) % static_cast<int>(p.panel->corners.size()));
  }
}

}  // namespace plico
