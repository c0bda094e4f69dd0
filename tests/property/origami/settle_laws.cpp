// Patterns that fold exactly, rounded as drawing programs round them, fold again when they are settled.
#include <gtest/gtest.h>

#include <cmath>

#include "effort.h"
#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/rng.h"
#include "plico/origami/approach.h"
#include "plico/origami/assign.h"
#include "plico/origami/closure.h"
#include "plico/origami/drawing_symmetry.h"
#include "plico/origami/patterns.h"
#include "plico/origami/settle.h"

namespace plico {
namespace {

CreasePattern rounded_to(CreasePattern sheet, int decimals) {
  const double unit = std::pow(10, -decimals);
  for (Vec2& p : sheet.vertices) p = (p / unit).array().round().matrix() * unit;
  return sheet;
}

// Creases from one point whose sectors add up to pi, every other one, with letters that fold it flat.
CreasePattern random_flat_foldable_vertex(Rng& rng, int degree) {
  std::vector<double> sectors(degree);
  for (int side : {0, 1}) {
    double sum = 0;
    for (int i = side; i < degree; i += 2) sum += sectors[i] = rng.uniform(0.5, 1.5);
    for (int i = side; i < degree; i += 2) sectors[i] *= kPi / sum;
  }
  CreasePattern sheet;
  sheet.vertices.emplace_back(0, 0);
  double at = rng.uniform(0, 1);
  for (int i = 0; i < degree; ++i) {
    sheet.vertices.emplace_back(plico::cos(at), plico::sin(at));
    at += sectors[i];
    const int next = (i + 1) % degree;
    sheet.edges.push_back({0, i + 1, Assignment::Unassigned, 0});
    sheet.edges.push_back({i + 1, next + 1, Assignment::Boundary, 0});
    sheet.faces.push_back({0, i + 1, next + 1});
  }
  const AssignResult assigned = assign_creases(sheet);
  PLICO_ASSERT(assigned.ending == Ending::Found);
  return assigned.sheet;
}

constexpr double kMiuraSector = 1.1;

// Of a vertex of a Miura with unit width and height.
std::pair<int, int> column_and_row(const Vec2& p) {
  const int j = static_cast<int>(std::lround(p.y()));
  return {static_cast<int>(std::lround(p.x() - (j % 2 ? 1 / plico::tan(kMiuraSector) : 0))), j};
}

// A Miura whose columns and rows have widths and heights of their own: flat-foldable and rigid as the even one is.
CreasePattern random_miura(Rng& rng) {
  const int columns = 2 + static_cast<int>(rng.uniform(0, 3)), rows = 2 + static_cast<int>(rng.uniform(0, 3));
  const double sector = rng.uniform(0.9, 1.3);
  CreasePattern sheet = miura({.columns = columns, .rows = rows, .sector = kMiuraSector});
  std::vector<double> x = {0}, y = {0}, shear = {0};
  for (int i = 0; i < columns; ++i) x.push_back(x.back() + rng.uniform(0.6, 1.5));
  for (int j = 0; j < rows; ++j) {
    const double height = rng.uniform(0.6, 1.5);
    y.push_back(y.back() + height);
    shear.push_back(shear.back() + (j % 2 ? -1 : 1) * height / plico::tan(sector));
  }
  for (Vec2& p : sheet.vertices) {
    const auto [i, j] = column_and_row(p);
    p = Vec2(x[i] + shear[j], y[j]);
  }
  return sheet;
}

// Quadrilaterals of which no two columns or rows are alike: trapezoids between parallel lines, with a sector for each
// zigzag. Along a zigzag all sectors are equal, so what each panel asks of its creases agrees; it folds flat and
// rigidly.
CreasePattern random_quads(Rng& rng) {
  const int columns = 2 + static_cast<int>(rng.uniform(0, 3)), rows = 2 + static_cast<int>(rng.uniform(0, 3));
  CreasePattern sheet = miura({.columns = columns, .rows = rows, .sector = kMiuraSector});
  std::vector<double> x = {0}, slope, y = {0};
  for (int i = 0; i < columns; ++i) x.push_back(x.back() + rng.uniform(1.0, 1.6));
  for (int i = 0; i <= columns; ++i) slope.push_back(1 / plico::tan(rng.uniform(0.9, 1.3)));
  for (int j = 0; j < rows; ++j) y.push_back(y.back() + rng.uniform(0.6, 1.2));
  for (Vec2& p : sheet.vertices) {
    const auto [i, j] = column_and_row(p);
    double along = x[i];
    for (int k = 0; k < j; ++k) along += (k % 2 ? -1 : 1) * (y[k + 1] - y[k]) * slope[i];
    p = Vec2(along, y[j]);
  }
  return sheet;
}

constexpr double kUnit = 10;  // length of an edge, about: people draw in millimetres or pixels

CreasePattern turned(CreasePattern sheet, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  for (Vec2& p : sheet.vertices) p = kUnit * (turn * p);
  return sheet;
}

CreasePattern random_pattern(Rng& rng, int round) {
  switch (round % 7) {
    case 0:
      return random_flat_foldable_vertex(rng, 4);
    case 1:
      return random_flat_foldable_vertex(rng, 6);
    case 2:
      return random_miura(rng);
    case 3:
      return random_quads(rng);
    case 4:
      return miura({.columns = 3 + round % 3, .rows = 3, .sector = rng.uniform(0.8, 1.4)});
    case 5:
      return waterbomb({.columns = 2 + 2 * (round % 2), .rows = 2, .diagonal_angle = rng.uniform(0.4, 0.9)});
    default:
      return yoshimura({.columns = 3 + round % 2, .rows = 2, .diagonal_angle = rng.uniform(0.4, 0.9)});
  }
}

double share_of(const CreasePattern& sheet) { return approach_goal(sheet, {}, {.frames = 15}).progress; }

double farthest_move(const CreasePattern& from, const CreasePattern& to) {
  double move = 0;
  for (int v = 0; v < from.num_vertices(); ++v) move = std::max(move, (to.vertices[v] - from.vertices[v]).norm());
  return move;
}

TEST(SettleLaws, RoundedPatternsCloseAndFoldAsTheExactOnesDo) {
  for (int round = 0; round < num_cases(200); ++round) {
    Rng rng = Rng(20170503).stream(round);
    const CreasePattern pattern = random_pattern(rng, round);
    const CreasePattern exact = turned(pattern, rng.uniform(0, 1));
    const int decimals = 2 + round % 3;
    const CreasePattern drawn = rounded_to(exact, decimals);
    const Settled settled = settle(drawn);
    ASSERT_TRUE(settled.closed) << "round " << round;
    EXPECT_LT(settled.open, 1e-12) << "round " << round;
    EXPECT_LT(settled.move, 30 * std::pow(10, -decimals)) << "round " << round;
    EXPECT_EQ(settled.move, farthest_move(drawn, settled.sheet)) << "round " << round;
    EXPECT_GE(share_of(settled.sheet), share_of(exact) - 0.02) << "round " << round;
    const auto symmetries = drawing_symmetries(settled.sheet, 1e-10).size();
    EXPECT_GE(symmetries, drawing_symmetries(exact, 1e-10).size()) << "round " << round;
  }
}

}  // namespace
}  // namespace plico
