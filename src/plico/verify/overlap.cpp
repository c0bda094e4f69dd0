#include "plico/verify/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "plico/geom/polygon.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

using Triangle = std::array<Vec2, 3>;

// A counter-clockwise triangle of a panel with its box.
struct Piece {
  Triangle corners;
  double low_x, high_x, low_y, high_y;
  int panel;
};

void add_triangle(const Triangle& t, int panel, std::vector<Piece>& pieces) {
  const auto& [a, b, c] = t;
  const int turn = orient2d(a, b, c);
  if (turn == 0) return;  // no interior
  const auto [low_x, high_x] = std::minmax({a.x(), b.x(), c.x()});
  const auto [low_y, high_y] = std::minmax({a.y(), b.y(), c.y()});
  pieces.push_back({turn > 0 ? t : Triangle{a, c, b}, low_x, high_x, low_y, high_y, panel});
}

void shrink_to(const Vec2& middle, double shrink, std::span<Vec2> corners) {
  for (Vec2& p : corners) p += (middle - p) * shrink;
}

Vec2 mean(std::span<const Vec2> corners) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : corners) sum += p;
  return sum / static_cast<double>(corners.size());
}

// A point that sees the whole panel from inside: toward it the panel shrinks into itself.
bool sees_all_sides(const Vec2& middle, std::span<const Vec2> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (orient2d(corners[i], corners[(i + 1) % corners.size()], middle) <= 0) return false;
  return true;
}

// A triangle thinner than the shrinking would take away from a panel of its length.
bool is_thin(const Triangle& t, double shrink) {
  const double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  return std::abs(cross(Vec2(t[1] - t[0]), Vec2(t[2] - t[0]))) <= shrink * longest * longest;
}

void add_panel(const CreasePattern& sheet, int panel, double shrink, std::vector<Piece>& pieces) {
  const std::vector<int>& face = sheet.faces[panel];
  if (face.size() == 3) {
    Triangle t{sheet.vertices[face[0]], sheet.vertices[face[1]], sheet.vertices[face[2]]};
    shrink_to(mean(t), shrink, t);
    return add_triangle(t, panel, pieces);
  }
  std::vector<Vec2> corners = polygon(sheet, panel);
  if (signed_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  const Vec2 middle = mean(corners);
  const bool whole = sees_all_sides(middle, corners);
  if (whole) shrink_to(middle, shrink, corners);
  for (const auto& [i, j, k] : triangulate(corners)) {
    Triangle t{corners[i], corners[j], corners[k]};
    if (!whole && is_thin(t, shrink)) continue;
    if (!whole) shrink_to(mean(t), shrink, t);
    add_triangle(t, panel, pieces);
  }
}

// All corners of t on or right of one side of s.
bool side_separates(const Triangle& s, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const Vec2 &a = s[i], &b = s[i == 2 ? 0 : i + 1];
    if (orient2d(a, b, t[0]) <= 0 && orient2d(a, b, t[1]) <= 0 && orient2d(a, b, t[2]) <= 0) return true;
  }
  return false;
}

bool share_interior(const Triangle& s, const Triangle& t) { return !side_separates(s, t) && !side_separates(t, s); }

// Walks through the pieces by their left ends and keeps those that the walk still cuts in strips of y.
class Sweep {
 public:
  explicit Sweep(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
      return a.low_x != b.low_x ? a.low_x < b.low_x : a.panel < b.panel;
    });
    if (pieces_.empty()) return;
    double heights = 0, high = pieces_[0].high_y;
    bottom_ = pieces_[0].low_y;
    for (const Piece& piece : pieces_) {
      heights += piece.high_y - piece.low_y;
      bottom_ = std::min(bottom_, piece.low_y);
      high = std::max(high, piece.high_y);
    }
    // As tall as a mean box: a box lies in about two strips, and all strips together are no longer than the pieces.
    const double n = static_cast<double>(pieces_.size());
    const double wanted = (high - bottom_) / (heights / n);
    strips_.resize(wanted > 1 ? static_cast<std::size_t>(std::min(wanted, n)) : 1);
    per_unit_ = static_cast<double>(strips_.size()) / (high - bottom_);
  }

  // Panel pairs, sorted, each once. False when it was stopped.
  bool run(long max_pairs, const Run& run, std::vector<std::pair<int, int>>& pairs) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (i % 4096 == 0 && run.over()) return false;
      const std::size_t first = strip(pieces_[i].low_y), last = strip(pieces_[i].high_y);
      for (std::size_t s = first; s <= last; ++s) visit(s, pieces_[i], pairs);
      for (std::size_t s = first; s <= last; ++s) strips_[s].push_back(static_cast<int>(i));
      if (static_cast<long>(pairs.size()) >= max_pairs) return false;
    }
    return true;
  }

 private:
  std::size_t strip(double y) const {
    if (strips_.size() == 1) return 0;
    return std::min(static_cast<std::size_t>((y - bottom_) * per_unit_), strips_.size() - 1);
  }

  void visit(std::size_t s, const Piece& piece, std::vector<std::pair<int, int>>& pairs) {
    std::vector<int>& active = strips_[s];
    for (std::size_t at = 0; at < active.size();) {
      const Piece& other = pieces_[active[at]];
      if (other.high_x <= piece.low_x) {
        active[at] = active.back();
        active.pop_back();
        continue;
      }
      ++at;
      if (other.panel == piece.panel || other.high_y <= piece.low_y || piece.high_y <= other.low_y) continue;
      if (s != strip(std::max(piece.low_y, other.low_y))) continue;  // counted in the first strip they share
      if (share_interior(piece.corners, other.corners)) pairs.push_back(std::minmax(piece.panel, other.panel));
    }
  }

  std::vector<Piece> pieces_;
  std::vector<std::vector<int>> strips_;
  double bottom_ = 0, per_unit_ = 0;
};

// Area of the intersection of two triangles (Sutherland and Hodgman's clipping).
double shared_area(const Triangle& s, const Triangle& t) {
  std::vector<Vec2> shape(s.begin(), s.end()), clipped;
  for (int i = 0; i < 3 && !shape.empty(); ++i) {
    const Vec2 &a = t[i], along = t[(i + 1) % 3] - a;
    const auto inside = [&](const Vec2& p) { return cross(along, Vec2(p - a)); };
    clipped.clear();
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const Vec2 &p = shape[k], &q = shape[(k + 1) % shape.size()];
      const double at_p = inside(p), at_q = inside(q);
      if (at_p >= 0) clipped.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) clipped.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    shape.swap(clipped);
  }
  return shape.size() < 3 ? 0 : std::max(0.0, signed_area(shape));
}

double shared_area(const CreasePattern& sheet, int a, int b, double shrink) {
  std::vector<Piece> first, second;
  add_panel(sheet, a, shrink, first);
  add_panel(sheet, b, shrink, second);
  double area = 0;
  for (const Piece& s : first)
    for (const Piece& t : second) area += shared_area(s.corners, t.corners);
  return area;
}

}  // namespace

Overlaps find_overlaps(const CreasePattern& sheet, const OverlapOptions& options, const Run& run) {
  std::vector<Piece> pieces;
  pieces.reserve(sheet.faces.size());
  for (int f = 0; f < sheet.num_faces(); ++f) add_panel(sheet, f, options.shrink, pieces);
  std::vector<std::pair<int, int>> pairs;
  Overlaps overlaps;
  overlaps.complete = Sweep(std::move(pieces)).run(options.max_pairs, run, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  overlaps.count = static_cast<long>(pairs.size());
  const auto listed = std::min(pairs.size(), static_cast<std::size_t>(options.max_listed));
  for (std::size_t i = 0; i < listed; ++i) {
    const auto [a, b] = pairs[i];
    overlaps.listed.push_back({a, b, shared_area(sheet, a, b, options.shrink)});
    if (overlaps.worst.a < 0 || overlaps.listed.back().area > overlaps.worst.area)
      overlaps.worst = overlaps.listed.back();
  }
  return overlaps;
}

}  // namespace plico
