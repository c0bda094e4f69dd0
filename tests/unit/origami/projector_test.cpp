#include "plico/origami/projector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

// A Miura sheet without its panel in the middle, whose sides become a border.
CreasePattern ring(int size = 5) {
  CreasePattern sheet = miura({.columns = size, .rows = size, .zigzag_angle = radians(100)});
  const auto at = sheet.faces.begin() + size * (size / 2) + size / 2;
  const std::vector<int> middle = *at;
  sheet.faces.erase(at);
  const auto in_middle = [&](int v) { return std::count(middle.begin(), middle.end(), v) > 0; };
  for (Crease& edge : sheet.edges)
    if (in_middle(edge.a) && in_middle(edge.b)) edge.assignment = Assignment::Boundary;
  return sheet;
}

Configuration bent(const CreasePattern& sheet, double by) {
  Configuration config = goal(make_linkage(sheet));
  for (int h = 0; h < config.size(); ++h) config[h] += by * std::sin(1.7 * h);
  return config;
}

TEST(Hole, IsOneLoopOfSixEquations) {
  const std::vector<RealVertex> loops = real_vertices(ring());
  ASSERT_EQ(loops.size(), 16u - 4 + 1);
  EXPECT_TRUE(loops.back().is_hole());
  EXPECT_EQ(loops.back().num_equations(), 6);
  EXPECT_EQ(loops.back().hinges.size(), 8u);
  EXPECT_EQ(std::count_if(loops.begin(), loops.end(), [](const RealVertex& v) { return v.is_hole(); }), 1);
}

TEST(Hole, TheMotionOfTheWholeSheetCloses) {
  const CreasePattern sheet = ring();
  const Linkage linkage = make_linkage(sheet);
  EXPECT_LT(closure(real_vertices(sheet), goal(linkage)).worst, 1e-13);
  EXPECT_LT(tear(sheet, linkage, goal(linkage)).gap, 1e-13);
}

TEST(Hole, ClosedVerticesAloneTearTheRing) {
  const CreasePattern sheet = ring(4);
  const Linkage linkage = make_linkage(sheet);
  std::vector<RealVertex> loops = real_vertices(sheet);
  const Projection whole = project(loops, bent(sheet, 0.05));
  ASSERT_TRUE(whole.closed) << whole.closure.worst << " after " << whole.steps;
  EXPECT_LT(tear(sheet, linkage, whole.config).gap, 1e-12);
  loops.pop_back();
  const Projection torn = project(loops, bent(sheet, 0.05));
  EXPECT_TRUE(torn.closed);
  EXPECT_GT(tear(sheet, linkage, torn.config).gap, 1e-3);
}

TEST(Hole, ProjectionConvergesQuadratically) {
  const CreasePattern sheet = ring(7);
  Projector projector(sheet);
  const Projection found = projector.project(bent(sheet, 0.02));
  EXPECT_TRUE(found.closed) << found.closure.worst;
  EXPECT_LE(found.steps, 8);
}

// A strip of four squares around a slit of no width: two vertices lie on each other.
TEST(Hole, ASlitIsOne) {
  CreasePattern sheet;
  for (int y = 0; y <= 2; ++y)
    for (int x = 0; x <= 4; ++x) sheet.vertices.emplace_back(x, y);
  const auto at = [](int x, int y) { return y * 5 + x; };
  sheet.vertices.emplace_back(2, 1);  // the lower rim of the slit from (1, 1) to (3, 1)
  const int below = 15;
  const auto lower = [&](int x) { return x == 2 ? below : at(x, 1); };
  for (int x = 0; x < 4; ++x) {
    sheet.faces.push_back({at(x, 0), at(x + 1, 0), lower(x + 1), lower(x)});
    sheet.faces.push_back({at(x, 1), at(x + 1, 1), at(x + 1, 2), at(x, 2)});
    sheet.edges.push_back({at(x, 0), at(x + 1, 0), Assignment::Boundary, 0});
    sheet.edges.push_back({at(x, 2), at(x + 1, 2), Assignment::Boundary, 0});
  }
  for (int x : {0, 3}) sheet.edges.push_back({at(x, 1), at(x + 1, 1), Assignment::Mountain, -1});
  for (int x : {1, 2}) {
    sheet.edges.push_back({at(x, 1), at(x + 1, 1), Assignment::Boundary, 0});
    sheet.edges.push_back({lower(x), lower(x + 1), Assignment::Boundary, 0});
  }
  for (int x = 1; x < 4; ++x) {
    sheet.edges.push_back({at(x, 0), lower(x), Assignment::Valley, 1});
    sheet.edges.push_back({at(x, 1), at(x, 2), Assignment::Valley, 1});
  }
  for (int x : {0, 4}) {
    sheet.edges.push_back({at(x, 0), at(x, 1), Assignment::Boundary, 0});
    sheet.edges.push_back({at(x, 1), at(x, 2), Assignment::Boundary, 0});
  }
  const std::vector<RealVertex> loops = real_vertices(sheet);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_TRUE(loops.front().is_hole());
  EXPECT_EQ(loops.front().hinges.size(), 8u);
  const Linkage linkage = make_linkage(sheet);
  Configuration start = 0.5 * goal(linkage);
  const Projection found = project(loops, start);
  EXPECT_TRUE(found.closed) << found.closure.worst;
  EXPECT_LT(tear(sheet, linkage, found.config).gap, 1e-12);
}

TEST(Hole, PanelsThatLieOnEachOtherAreRefused) {
  CreasePattern sheet = miura();
  sheet.faces.push_back(sheet.faces.front());
  EXPECT_THROW(real_vertices(sheet), InvalidInput);
}

TEST(Projector, HasNothingToDoWithoutRealVertices) {
  const CreasePattern strip = l();
  const Configuration target = goal(make_linkage(strip));
  EXPECT_EQ(Projector(strip).project(target).config, target);
  EXPECT_EQ(Projector(strip).tangent(0 * target, target), target);
  const CreasePattern panel = miura({.columns = 1, .rows = 1});
  EXPECT_TRUE(Projector(panel).project(Configuration()).closed);
}

TEST(Projector, IsReusedWithoutMemory) {
  const CreasePattern sheet = waterbomb({.columns = 6, .rows = 6});
  const Configuration target = goal(make_linkage(sheet));
  Projector projector(sheet);
  const Configuration first = projector.project(0.5 * target).config;
  projector.project(0.9 * target);
  EXPECT_EQ(projector.project(0.5 * target).config, first);
  EXPECT_EQ(project(real_vertices(sheet), 0.5 * target).config, first);
}

TEST(Projector, LimitsHold) {
  const CreasePattern sheet = miura({.columns = 5, .rows = 4, .zigzag_angle = radians(120)});
  const Configuration target = goal(make_linkage(sheet));
  Projector projector(sheet);
  ProjectOptions options;
  options.low = Configuration::Constant(target.size(), -radians(90));
  options.high = Configuration::Constant(target.size(), radians(90));
  const Projection found = projector.project(target, options);
  ASSERT_TRUE(found.closed) << found.closure.worst;
  EXPECT_LE(found.config.cwiseAbs().maxCoeff(), radians(90));
  EXPECT_GT(found.config.cwiseAbs().maxCoeff(), radians(80));
}

TEST(Projector, EndsBetweenTwoStepsWhenTheRunIsOverOrItStraysTooFar) {
  const CreasePattern sheet = miura({.columns = 5, .rows = 4, .zigzag_angle = radians(120)});
  const Configuration start = Configuration::Constant(make_linkage(sheet).num_hinges(), 0.5);
  EXPECT_EQ(Projector(sheet).project(start, {}, limited({}, 0)).steps, 0);
  EXPECT_FALSE(Projector(sheet).project(start, {}, limited({}, 0)).closed);
  ProjectOptions near;
  near.most_turn = 1e-3;
  const Projection strayed = Projector(sheet).project(start, near);
  EXPECT_EQ(strayed.steps, 1);
  EXPECT_FALSE(strayed.closed);
}

TEST(Projector, HeldFacetsStayFlat) {
  const CreasePattern sheet = miura({.columns = 4, .rows = 4, .facet_diagonals = true});
  const Configuration target = goal(make_linkage(sheet));
  ProjectOptions options;
  options.low = Configuration::Constant(target.size(), -kPi);
  options.high = Configuration::Constant(target.size(), kPi);
  for (int h = 0; h < target.size(); ++h)
    if (target[h] == 0) options.low[h] = options.high[h] = 0;
  const Projection found = Projector(sheet).project(0.5 * target, options);
  ASSERT_TRUE(found.closed) << found.closure.worst;
  for (int h = 0; h < target.size(); ++h)
    if (target[h] == 0) {
      EXPECT_EQ(found.config[h], 0);
    }
}

TEST(Projector, TangentKeepsTheSheetClosedToFirstOrder) {
  const CreasePattern sheet = waterbomb({.columns = 6, .rows = 6});
  Projector projector(sheet);
  const Configuration target = goal(make_linkage(sheet));
  const Configuration at = projector.project(0.5 * target).config;
  const Configuration direction = projector.tangent(at, target);
  EXPECT_GT(direction.norm(), 0.5 * target.norm());
  const double near = closure(projector.vertices(), at + 1e-3 * direction).worst;
  const double nearer = closure(projector.vertices(), at + 1e-4 * direction).worst;
  EXPECT_LT(near, 1e-4);
  EXPECT_LT(nearer, 0.02 * near);  // second order: a tenth of the way, a hundredth of the error
}

TEST(Projector, WrongSizesAreRefused) {
  const CreasePattern sheet = miura();
  EXPECT_THROW(Projector(real_vertices(sheet), 3), InvalidInput);
  Projector projector(sheet);
  EXPECT_THROW(projector.project(Configuration::Zero(3)), InvalidInput);
  EXPECT_THROW(projector.project(Configuration::Zero(projector.num_creases()), {.tolerance = 0}), InvalidOption);
}

TEST(Tear, MeasuresTheGapAndTheDeformation) {
  const CreasePattern cross = l2();
  const Linkage linkage = make_linkage(cross);
  Configuration open = flat(linkage);
  EXPECT_EQ(tear(cross, linkage, open).gap, 0);
  EXPECT_EQ(tear(cross, linkage, open).vertex, -1);
  open[linkage.loop_hinges.front()] = 0.3;  // outside the tree: panels stay, only the residual sees it
  EXPECT_EQ(tear(cross, linkage, open).gap, 0);
  EXPECT_NEAR(closure(real_vertices(cross), open).worst, 0.3, 1e-12);
  open = flat(linkage);
  open[linkage.parent_hinge[linkage.order.back()]] = kPi / 3;
  const Tear found = tear(cross, linkage, open);
  EXPECT_NEAR(found.gap, 1 / std::sqrt(8.0), 1e-12);  // side 1 of a 2 by 2 sheet, turned by 60 degrees
  EXPECT_GT(found.deformation, 0.05);
}

}  // namespace
}  // namespace plico
