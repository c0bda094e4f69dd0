#include "plico/fabricate/joints.h"

#include <algorithm>

#include "plico/base/libm.h"
#include "plico/fabricate/pieces.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

constexpr double kTick = 6;     // millimetres, at most
constexpr double kClear = 1;    // millimetres of paper around the hole of a rivet, and between it and the text
constexpr double kInset = 0.4;  // of the polygon from the sides of its panel, so that both lines are seen

std::vector<Vec2> on_page(const JointFacet& facet, const Placement& at, double scale) {
  std::vector<Vec2> polygon;
  for (const Vec2& p : facet.polygon) polygon.push_back(at(scale * p));
  return polygon;
}

double longest_side_angle(const std::vector<Vec2>& polygon) {
  Vec2 longest(0, 0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (side.norm() > longest.norm() + 1e-9) longest = side;
  }
  double angle = plico::atan2(longest.y(), longest.x());
  while (angle > kPi / 2) angle -= kPi;
  while (angle <= -kPi / 2) angle += kPi;
  return angle;
}

// Is a box of this size around `center` inside a convex polygon?
bool fits(const std::vector<Vec2>& polygon, const Vec2& center, double angle, const Vec2& size) {
  const Vec2 u = rotation(angle) * Vec2(size.x() / 2, 0), v = rotation(angle) * Vec2(0, size.y() / 2);
  for (const Vec2& corner : {Vec2(center - u - v), Vec2(center + u - v), Vec2(center + u + v), Vec2(center - u + v)})
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
      if (cross(side, Vec2(corner - polygon[i])) < 0) return false;
    }
  return true;
}

// How far the middle of the text may be from that of the polygon, across the line of writing.
std::vector<double> shifts(JointKind kind, double height) {
  if (kind != JointKind::Rivet) return {0};
  const double beside_hole = kRivet / 2 + height / 2 + kClear;
  return {-beside_hole, beside_hole};
}

bool write_joint(PlacedPart& part, const std::vector<Vec2>& polygon, const std::string& text, JointKind kind,
                 const Font& font) {
  const Vec2 middle = centroid(polygon);
  for (double pt : {10.0, 8.0, 7.0, 6.0, 5.0, 4.0})
    for (double angle : {0.0, longest_side_angle(polygon)}) {
      const double size = pt * kMillimetresPerPoint;
      const Vec2 room(font.width(text, size) + 0.4 * size, Font::cap_height(size) + 0.4 * size);
      for (double shift : shifts(kind, room.y())) {
        const Vec2 at = middle + rotation(angle) * Vec2(0, shift);
        if (!fits(polygon, at, angle, room)) continue;
        part.labels.push_back({text, at, angle, size});
        return true;
      }
    }
  return false;
}

// The hole, a ring of strokes, with a cross at its middle to pierce; none where paper would tear beside it.
bool add_hole(PlacedPart& part, const std::vector<Vec2>& polygon) {
  const Vec2 middle = centroid(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (side.norm() > 0 && cross(side, Vec2(middle - polygon[i])) / side.norm() < kRivet / 2 + kClear) return false;
  }
  constexpr int kCorners = 24;
  Mark ring{{}, true};
  for (int i = 0; i < kCorners; ++i)
    ring.points.push_back(middle + rotation(2 * kPi * i / kCorners) * Vec2(kRivet / 2, 0));
  part.marks.push_back(std::move(ring));
  for (const Vec2& arm : {Vec2(kRivet / 4, 0), Vec2(0, kRivet / 4)})
    part.marks.push_back({{middle - arm, middle + arm}, false});
  return true;
}

// A stroke from the corner `up` towards the middle, clear of the text there.
Mark tick(const std::vector<Vec2>& polygon, int up) {
  const Vec2& from = polygon[up];
  const Vec2 way = centroid(polygon) - from;
  const double length = std::min(kTick, 0.4 * way.norm());
  return {{from, from + length * way.normalized()}, false};
}

std::vector<Vec2> inset(const std::vector<Vec2>& polygon) {
  const Vec2 middle = centroid(polygon);
  std::vector<Vec2> inner;
  for (const Vec2& p : polygon) {
    const double away = (p - middle).norm();
    inner.push_back(away > 2 * kInset ? Vec2(p + (middle - p) * (kInset / away)) : p);
  }
  return inner;
}

}  // namespace

int write_joints(PageLayout& layout, const std::vector<JointFacet>& facets, JointKind kind,
                 const std::vector<int>& part_of_panel, const std::vector<Placement>& placed, const Font& font) {
  if (kind == JointKind::None) return 0;
  int omitted = 0;
  for (const JointFacet& facet : facets) {
    const int part = part_of_panel[facet.panel];
    const std::vector<Vec2> polygon = on_page(facet, placed[part], layout.scale);
    if (!write_joint(layout.parts[part], polygon, facet.text, kind, font)) ++omitted;
  }
  return omitted;
}

int draw_joints(PageLayout& layout, const std::vector<JointFacet>& facets, JointKind kind,
                const std::vector<int>& part_of_panel, const std::vector<Placement>& placed) {
  if (kind == JointKind::None) return 0;
  int without_hole = 0;
  for (const JointFacet& facet : facets) {
    PlacedPart& part = layout.parts[part_of_panel[facet.panel]];
    const std::vector<Vec2> polygon = inset(on_page(facet, placed[part_of_panel[facet.panel]], layout.scale));
    part.marks.push_back({polygon, true});
    part.marks.push_back(tick(polygon, facet.up));
    if (kind == JointKind::Rivet && !add_hole(part, polygon)) ++without_hole;
  }
  return without_hole;
}

}  // namespace plico
