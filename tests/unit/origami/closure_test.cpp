#include "plico/origami/projector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

struct Case {
  std::vector<RealVertex> vertices;
  Configuration goal;
};

Case prepare(const CreasePattern& sheet) { return {real_vertices(sheet), goal(make_linkage(sheet))}; }

// Table 3.2: the closed configurations whose fold angles are 0, the goal, 180 (and, with `quarter`, 90) degrees.
int count_discrete(const CreasePattern& sheet, bool quarter) {
  const Case c = prepare(sheet);
  std::vector<std::vector<double>> choices;
  for (double g : c.goal) {
    const double sign = g < 0 ? -1 : 1;
    std::set<double> set{0, sign * kPi, g};
    if (quarter) set.insert(sign * kPi / 2);
    choices.emplace_back(set.begin(), set.end());
  }
  std::vector<std::size_t> digit(choices.size(), 0);
  Configuration config(c.goal.size());
  int count = 0;
  for (;;) {
    for (std::size_t i = 0; i < digit.size(); ++i) config[static_cast<int>(i)] = choices[i][digit[i]];
    if (closure(c.vertices, config).worst < 1e-9) ++count;
    std::size_t i = 0;
    while (i < digit.size() && ++digit[i] == choices[i].size()) digit[i++] = 0;
    if (i == digit.size()) return count;
  }
}

// Around 60 creases and back again along the same ones: rounding must not grow from crease to crease.
TEST(Closure, IsSharpAroundManyCreases) {
  constexpr int kCreases = 60;
  RealVertex there_and_back;
  there_and_back.vertex = 0;
  Configuration config(2 * kCreases);
  for (int k = 0; k < 2 * kCreases; ++k) {
    const int crease = std::min(k, 2 * kCreases - 1 - k);
    const double at = 2 * kPi * crease / kCreases;
    there_and_back.hinges.push_back(k);
    there_and_back.directions.emplace_back(std::cos(at), std::sin(at));
    config[k] = (crease % 2 == 0 ? 1.4 : -1.5) * (k < kCreases ? 1 : -1);
  }
  EXPECT_LT(closure({there_and_back}, config).worst, 1e-13);
}

TEST(Closure, CountsOfTable32ComeOut) {
  EXPECT_EQ(count_discrete(l2(), false), 5);
  EXPECT_EQ(count_discrete(l2(), true), 6);
  EXPECT_EQ(count_discrete(waterbomb_base(), false), 71);
  EXPECT_EQ(count_discrete(waterbomb_base(), true), 114);
  EXPECT_EQ(count_discrete(miura(), false), 7);
  EXPECT_EQ(count_discrete(miura(), true), 7);
}

TEST(Closure, GoalsOfTheTessellationsClose) {
  for (double degree : {30.0, 90.0, 150.0}) {
    const Case m = prepare(miura({.columns = 24, .rows = 24, .zigzag_angle = radians(degree)}));
    EXPECT_LT(closure(m.vertices, m.goal).worst, 1e-13);
    const Case w = prepare(waterbomb({.columns = 12, .rows = 22, .diagonal_angle = radians(degree / 2)}));
    EXPECT_LT(closure(w.vertices, w.goal).worst, 1e-13);
  }
}

TEST(Closure, GoalOfTheDiamondCloses) {
  const Case c = prepare(diamond());
  EXPECT_LT(closure(c.vertices, c.goal).worst, 1e-13);
}

TEST(Closure, TurningTheSheetOverKeepsTheResiduals) {
  const Case c = prepare(waterbomb());
  const Configuration half = c.goal.array() * c.goal.array();  // no configuration that closes
  const Closure front = closure(c.vertices, half), back = closure(c.vertices, -half);
  EXPECT_GT(front.worst, 0.01);
  for (std::size_t v = 0; v < front.residual.size(); ++v) EXPECT_NEAR(front.residual[v], back.residual[v], 1e-12);
}

TEST(Closure, TooFewAnglesAreRefused) {
  EXPECT_THROW(closure(prepare(miura()).vertices, Configuration::Zero(3)), InvalidInput);
}

TEST(Projection, StraightFramesOfAMiuraMeetItsClosedForm) {
  const MiuraOptions options{.columns = 6, .rows = 5, .zigzag_angle = radians(120)};
  const Case c = prepare(miura(options));
  const Projection found = project(c.vertices, 0.6 * c.goal);
  ASSERT_TRUE(found.closed) << found.closure.worst;
  const double zigzag = found.config.cwiseAbs().maxCoeff();
  for (int h = 0; h < c.goal.size(); ++h) {
    const bool is_zigzag = std::abs(c.goal[h]) > radians(100);
    const double expected = is_zigzag ? zigzag : 2 * std::atan(std::cos(options.sector) * std::tan(zigzag / 2));
    EXPECT_NEAR(std::abs(found.config[h]), expected, 1e-9);
    EXPECT_GT(found.config[h] * c.goal[h], 0);
  }
}

TEST(Projection, AFoldableConfigurationStays) {
  const Case c = prepare(waterbomb());
  const Projection found = project(c.vertices, c.goal);
  EXPECT_TRUE(found.closed);
  EXPECT_LT((found.config - c.goal).norm(), 1e-12);
}

}  // namespace
}  // namespace plico
