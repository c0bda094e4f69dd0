#include "plico/origami/patterns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fold/planar_faces.h"

namespace plico {
namespace {

// The points (x, y), 0 <= x <= columns and 0 <= y <= rows, and the creases between them.
class Grid {
 public:
  Grid(int columns, int rows) : columns_(columns), rows_(rows) { sheet_.vertices.resize((columns + 1) * (rows + 1)); }

  Vec2& at(int x, int y) { return sheet_.vertices[id(x, y)]; }
  void crease(int x, int y, int x2, int y2, double angle) { add(x, y, x2, y2, assignment_of(angle), angle); }
  void border(int x, int y, int x2, int y2) { add(x, y, x2, y2, Assignment::Boundary, 0); }

  CreasePattern finish() {
    for (int x = 0; x < columns_; ++x) {
      border(x, 0, x + 1, 0);
      border(x, rows_, x + 1, rows_);
    }
    for (int y = 0; y < rows_; ++y) {
      border(0, y, 0, y + 1);
      border(columns_, y, columns_, y + 1);
    }
    sheet_.faces = planar_faces(sheet_.vertices, sheet_.edges);
    return std::move(sheet_);
  }

 private:
  int id(int x, int y) const { return y * (columns_ + 1) + x; }
  void add(int x, int y, int x2, int y2, Assignment assignment, double angle) {
    sheet_.edges.push_back({id(x, y), id(x2, y2), assignment, angle});
  }

  CreasePattern sheet_;
  int columns_, rows_;
};

void check(const MiuraOptions& o) {
  require(o.columns >= 1, "columns", o.columns, "at least 1");
  require(o.rows >= 1, "rows", o.rows, "at least 1");
  require(o.sector > 0 && o.sector < kPi / 2, "sector", o.sector, "in (0, pi/2)");
  require(o.zigzag_angle >= 0 && o.zigzag_angle <= kPi, "zigzag angle", o.zigzag_angle, "in [0, pi]");
  require(o.width > 0, "width", o.width, "above 0");
  require(o.height > 0, "height", o.height, "above 0");
}

void check(const WaterbombOptions& o) {
  require(o.columns >= 2 && o.columns % 2 == 0, "columns", o.columns, "even and at least 2");
  require(o.rows >= 2 && o.rows % 2 == 0, "rows", o.rows, "even and at least 2");
  require(o.diagonal_angle >= 0 && o.diagonal_angle <= kPi, "diagonal angle", o.diagonal_angle, "in [0, pi]");
}

void check(const YoshimuraOptions& o) {
  require(o.columns >= 1, "columns", o.columns, "at least 1");
  require(o.rows >= 1, "rows", o.rows, "at least 1");
  require(o.sector > 0 && o.sector < kPi / 2, "sector", o.sector, "in (0, pi/2)");
  require(o.diagonal_angle >= 0 && o.diagonal_angle <= kPi, "diagonal angle", o.diagonal_angle, "in [0, pi]");
}

// The angle whose half has `factor` times the tangent; exact at 0 and pi.
double scaled_half_angle(double factor, double angle) {
  return 2 * plico::atan2(factor * plico::sin(angle / 2), plico::cos(angle / 2));
}

bool is_waterbomb_centre(int x, int y) { return y % 2 == 1 && (x + (y - 1) / 2) % 2 == 1; }

}  // namespace

CreasePattern miura(const MiuraOptions& options) {
  check(options);
  const int n = options.columns, m = options.rows;
  const double straight = scaled_half_angle(plico::cos(options.sector), options.zigzag_angle);
  Grid grid(n, m);
  for (int y = 0; y <= m; ++y) {
    const double shift = y % 2 == 1 ? options.height / plico::tan(options.sector) : 0;
    for (int x = 0; x <= n; ++x) grid.at(x, y) = Vec2(x * options.width + shift, y * options.height);
  }
  for (int y = 0; y < m; ++y)
    for (int x = 1; x < n; ++x) grid.crease(x, y, x, y + 1, x % 2 == 1 ? options.zigzag_angle : -options.zigzag_angle);
  for (int y = 1; y < m; ++y)
    for (int x = 0; x < n; ++x) grid.crease(x, y, x + 1, y, (x + y) % 2 == 0 ? straight : -straight);
  if (options.facet_diagonals)
    for (int y = 0; y < m; ++y)
      for (int x = 0; x < n; ++x) grid.crease(x, y, x + 1, y + 1, 0);
  return grid.finish();
}

CreasePattern waterbomb(const WaterbombOptions& options) {
  check(options);
  const int n = options.columns, m = options.rows;
  const double d = options.diagonal_angle;
  const double inside = scaled_half_angle(std::sqrt(0.5), d);
  const double across = scaled_half_angle(std::sqrt(2.0), d);
  const double between = 2 * across - inside;
  Grid grid(n, m);
  for (int y = 0; y <= m; ++y)
    for (int x = 0; x <= n; ++x) grid.at(x, y) = Vec2(x, y);
  for (int y = 0; y < m; ++y)
    for (int x = 1; x < n; ++x) grid.crease(x, y, x, y + 1, is_waterbomb_centre(x, y | 1) ? inside : between);
  for (int y = 1; y < m; ++y)
    for (int x = 0; x < n; ++x) {
      if (y % 2 == 0) grid.crease(x, y, x + 1, y, across);
      if (y % 2 == 1 && options.facet_horizontals) grid.crease(x, y, x + 1, y, 0);
    }
  for (int y = 0; y < m; ++y)
    for (int x = 0; x < n; ++x) {
      const int centre_line = y | 1, other_line = 2 * y + 1 - centre_line;
      const int centre = is_waterbomb_centre(x, centre_line) ? x : x + 1;
      grid.crease(centre, centre_line, 2 * x + 1 - centre, other_line, -d);
    }
  return grid.finish();
}

CreasePattern yoshimura(const YoshimuraOptions& options) {
  check(options);
  const int n = options.columns, m = options.rows;
  const double d = options.diagonal_angle;
  const double straight = scaled_half_angle(plico::cos(options.sector), d);
  Grid grid(n, m);
  for (int y = 0; y <= m; ++y)
    for (int x = 0; x <= n; ++x) grid.at(x, y) = Vec2(x + (y % 2) * 0.5, y * plico::tan(options.sector) / 2);
  for (int y = 0; y < m; ++y) {
    for (int x = 1; x < n; ++x) grid.crease(x, y, x, y + 1, -d);
    for (int x = 0; x < n; ++x) grid.crease(x + 1 - y % 2, y, x + y % 2, y + 1, -d);
  }
  for (int y = 1; y < m; ++y)
    for (int x = 0; x < n; ++x) grid.crease(x, y, x + 1, y, straight);
  return grid.finish();
}

double yoshimura_tube_angle(int columns, double sector) {
  const double sine = plico::sin(kPi / (2 * std::max(1, columns))) / plico::sin(sector);
  return sine < 1 ? 2 * plico::asin(sine) : kPi;
}

}  // namespace plico
