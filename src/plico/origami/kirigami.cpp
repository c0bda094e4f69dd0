#include "plico/origami/kirigami.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fold/planar_faces.h"

namespace plico {
namespace {

void check(const HoneycombOptions& o) {
  require(o.columns >= 1, "columns", o.columns, "at least 1");
  require(o.rows >= 1, "rows", o.rows, "at least 1");
  require(o.wall_angle >= 0 && o.wall_angle <= kPi / 2, "wall angle", o.wall_angle, "in [0, pi/2]");
  require(o.strip_angle >= 0 && o.strip_angle <= kPi, "strip angle", o.strip_angle, "in [0, pi]");
  require(o.height > 0, "height", o.height, "above 0");
}

void check(const RotatingSquaresOptions& o) {
  require(o.columns >= 2, "columns", o.columns, "at least 2");
  require(o.rows >= 2, "rows", o.rows, "at least 2");
  require(o.middle_angle >= 0 && o.middle_angle <= kPi, "middle angle", o.middle_angle, "in [0, pi]");
  require(o.gusset > 0 && o.gusset <= 1, "gusset", o.gusset, "in (0, 1]");
}

// Lines between places; equal places are one vertex.
class CutSheet {
 public:
  void crease(const Vec2& a, const Vec2& b, double angle) { add(a, b, assignment_of(angle), angle); }
  void border(const Vec2& a, const Vec2& b) { add(a, b, Assignment::Boundary, 0); }
  void slit(const Vec2& a, const Vec2& b) { add(a, b, Assignment::Cut, 0); }

  CreasePattern finish() {
    sheet_.faces = planar_faces(sheet_.vertices, sheet_.edges);
    return std::move(sheet_);
  }

 private:
  int vertex(const Vec2& p) {
    const auto [at, fresh] = vertex_.try_emplace({p.x(), p.y()}, sheet_.num_vertices());
    if (fresh) sheet_.vertices.push_back(p);
    return at->second;
  }
  void add(const Vec2& a, const Vec2& b, Assignment assignment, double angle) {
    const int from = vertex(a), to = vertex(b);
    sheet_.edges.push_back({from, to, assignment, angle});
  }

  CreasePattern sheet_;
  std::map<std::pair<double, double>, int> vertex_;
};

// The checkerboard's corners inside the sheet, where two black squares meet, and the gussets there.
class SquareTiling {
 public:
  explicit SquareTiling(const RotatingSquaresOptions& options) : o_(options) {
    // The angle whose tangent is sqrt 2 tan(m / 2), exact at 0 and pi.
    side_angle_ = plico::atan2(std::sqrt(2.0) * plico::sin(o_.middle_angle / 2), plico::cos(o_.middle_angle / 2));
  }

  CreasePattern run() {
    for (int y = 1; y < o_.rows; ++y)
      for (int x = 1; x < o_.columns; ++x) add_gusset(x, y);
    for (int y = 0; y < o_.rows; ++y)
      for (int x = y % 2; x < o_.columns; x += 2) add_square(x, y);
    return sheet_.finish();
  }

 private:
  using Side = std::pair<std::pair<int, int>, std::pair<int, int>>;  // of a square, the lower corner first

  // Squares turn to and fro like a chess board's rows; the white square that closes at a corner lies above it in even
  // columns, below it in odd ones.
  void add_gusset(int x, int y) {
    const int row = x % 2 == 1 ? y - 1 : y;
    const int column = (x + row) % 2 == 1 ? x : x - 1;
    const int right = column == x ? 1 : -1, up = row == y ? 1 : -1;
    const Vec2 corner(x, y), along(o_.gusset * right, 0), across(0, o_.gusset * up);
    const Vec2 middle = corner + (along + across) / 2;
    sheet_.crease(corner, corner + along, -side_angle_);
    sheet_.crease(corner, middle, o_.middle_angle);
    sheet_.crease(corner, corner + across, -side_angle_);
    sheet_.border(corner + along, middle);
    sheet_.border(middle, corner + across);
    gusset_end_[side({x, y}, {x + right, y})] = corner + along;
    gusset_end_[side({x, y}, {x, y + up})] = corner + across;
    gusset_corner_[side({x, y}, {x + right, y})] = corner;
    gusset_corner_[side({x, y}, {x, y + up})] = corner;
  }

  static Side side(std::pair<int, int> a, std::pair<int, int> b) { return std::minmax(a, b); }

  void add_square(int x, int y) {
    const std::pair<int, int> corners[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    for (std::size_t i = 0; i < std::size(corners); ++i) {
      const auto &a = corners[i], &b = corners[(i + 1) % std::size(corners)];
      add_side(side(a, b), Vec2(a.first, a.second), Vec2(b.first, b.second));
    }
  }

  // The rest of a side is the border of a hole or of the sheet.
  void add_side(const Side& side, const Vec2& a, const Vec2& b) {
    const auto end = gusset_end_.find(side);
    if (end == gusset_end_.end()) return sheet_.border(a, b);
    const Vec2& other = gusset_corner_.at(side) == a ? b : a;
    if (end->second != other) sheet_.border(end->second, other);
  }

  const RotatingSquaresOptions& o_;
  double side_angle_;
  CutSheet sheet_;
  std::map<Side, Vec2> gusset_end_, gusset_corner_;
};

struct PopUpBox {
  double left, right;  // of it
  double front, back;  // how far from the middle fold it begins and ends
};

// Three sides between two slits; the ridge is where both folds of the card would have it.
void add_box(CutSheet& sheet, const PopUpBox& box, double angle) {
  const double ridge = box.back - box.front;
  sheet.crease({box.left, -box.front}, {box.right, -box.front}, angle);
  sheet.crease({box.left, ridge}, {box.right, ridge}, -angle);
  sheet.crease({box.left, box.back}, {box.right, box.back}, angle);
  double ends[] = {-box.front, 0, ridge, box.back};
  std::sort(std::begin(ends), std::end(ends));
  for (const double x : {box.left, box.right})
    for (std::size_t i = 0; i + 1 < std::size(ends); ++i) sheet.slit({x, ends[i]}, {x, ends[i + 1]});
}

}  // namespace

CreasePattern honeycomb(const HoneycombOptions& options) {
  check(options);
  const int walls = 4 * options.columns + 1;
  CutSheet sheet;
  for (int r = 0; r < options.rows; ++r) {
    const double low = r * options.height, high = (r + 1) * options.height;
    for (int c = 0; c <= walls; ++c) {
      const bool ridge = c % 4 < 2;  // from the top wall down, or down to it
      if (c == 0 || c == walls)
        sheet.border(Vec2(c, low), Vec2(c, high));
      else
        sheet.crease(Vec2(c, low), Vec2(c, high), ridge ? -options.wall_angle : options.wall_angle);
    }
  }
  for (int r = 0; r <= options.rows; ++r)
    for (int c = 0; c < walls; ++c) {
      const Vec2 a(c, r * options.height), b(c + 1, r * options.height);
      const int joined = r % 2 == 1 ? 0 : 2;  // top walls, then bottom walls, which then are on top
      if (r == 0 || r == options.rows)
        sheet.border(a, b);
      else if (c % 4 == joined)
        sheet.crease(a, b, joined == 0 ? options.strip_angle : -options.strip_angle);
      else
        sheet.slit(a, b);
    }
  return sheet.finish();
}

CreasePattern rotating_squares(const RotatingSquaresOptions& options) {
  check(options);
  return SquareTiling(options).run();
}

CreasePattern pop_up(double angle) {
  require(angle >= 0 && angle <= kPi, "angle", angle, "in [0, pi]");
  constexpr PopUpBox kBoxes[] = {{1, 2, 1, 2}, {3, 4, 2, 1}, {5, 6, 1.5, 2.5}};
  constexpr double kWidth = 7, kHalf = 3;
  CutSheet sheet;
  double at = 0;
  for (const PopUpBox& box : kBoxes) {
    sheet.crease({at, 0}, {box.left, 0}, angle);
    add_box(sheet, box, angle);
    at = box.right;
  }
  sheet.crease({at, 0}, {kWidth, 0}, angle);
  const Vec2 outline[] = {{0, 0}, {0, -kHalf}, {kWidth, -kHalf}, {kWidth, 0}, {kWidth, kHalf}, {0, kHalf}};
  for (std::size_t i = 0; i < std::size(outline); ++i) sheet.border(outline[i], outline[(i + 1) % std::size(outline)]);
  return sheet.finish();
}

}  // namespace plico
