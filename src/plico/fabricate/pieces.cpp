#include "plico/fabricate/pieces.h"

#include <algorithm>
#include <cmath>

#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

bool cross_properly(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

bool strictly_inside_convex(std::span<const Vec2> shape, const Vec2& p) {
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (orient2d(shape[i], shape[(i + 1) % shape.size()], p) <= 0) return false;
  return true;
}

// Even-odd rule with exact sides; on the boundary counts as inside.
bool in_polygon(std::span<const Vec2> polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const int side = orient2d(a, b, p);
    if (side == 0 && (p - a).dot(p - b) <= 0) return true;
    if ((a.y() > p.y()) != (b.y() > p.y()) && (side > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

Eigen::AlignedBox2d box_of(std::span<const Vec2> points) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : points) box.extend(p);
  return box;
}

}  // namespace

bool contains(std::span<const Vec2> polygon, std::span<const Vec2> shape) {
  for (const Vec2& p : shape)
    if (!in_polygon(polygon, p)) return false;
  if (is_convex(polygon)) return true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (strictly_inside_convex(shape, polygon[i])) return false;
    for (std::size_t j = 0; j < shape.size(); ++j)
      if (cross_properly(polygon[i], polygon[(i + 1) % polygon.size()], shape[j], shape[(j + 1) % shape.size()]))
        return false;
  }
  return true;
}

template <class Visit>
void PieceGrid::each_cell(const Eigen::AlignedBox2d& box, int group, Visit visit) const {
  const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
  for (std::int64_t y = index(box.min().y()); y <= index(box.max().y()); ++y)
    for (std::int64_t x = index(box.min().x()); x <= index(box.max().x()); ++x)
      if (!visit(static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u ^
                 static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu ^ static_cast<std::uint64_t>(group)))
        return;
}

void PieceGrid::add(std::vector<Vec2> convex, int group) {
  const Eigen::AlignedBox2d box = box_of(convex);
  const int id = static_cast<int>(pieces_.size());
  pieces_.push_back({std::move(convex), box, group});
  each_cell(box, group, [&](std::uint64_t key) {
    cells_[key].push_back(id);
    return true;
  });
}

bool PieceGrid::overlaps(std::span<const Vec2> shape, int group) const {
  const Eigen::AlignedBox2d box = box_of(shape);
  bool found = false;
  each_cell(box, group, [&](std::uint64_t key) {
    const auto cell = cells_.find(key);
    if (cell == cells_.end()) return true;
    for (int id : cell->second) {
      const Piece& piece = pieces_[id];
      if (piece.group != group || !piece.box.intersects(box)) continue;
      if (interiors_overlap_convex(shape, piece.corners)) {
        found = true;
        return false;
      }
    }
    return true;
  });
  return found;
}

}  // namespace plico
