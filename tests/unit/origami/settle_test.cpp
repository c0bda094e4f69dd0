#include "plico/origami/settle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/closure.h"
#include "plico/origami/drawing_symmetry.h"
#include "plico/origami/patterns.h"
#include "plico/origami/straight_lines.h"

namespace plico {
namespace {

// As someone draws it: at an angle, so that rounding does harm.
CreasePattern drawn_at_an_angle(CreasePattern sheet) {
  const Eigen::Rotation2Dd turn(0.3);
  for (Vec2& p : sheet.vertices) p = turn * p;
  return sheet;
}

CreasePattern rounded(CreasePattern sheet, double unit) {
  for (Vec2& p : sheet.vertices) p = (p / unit).array().round().matrix() * unit;
  return sheet;
}

double goal_open(const CreasePattern& sheet) { return closure(real_vertices(sheet), goal(make_linkage(sheet))).worst; }

double farthest_from_a_line(const CreasePattern& sheet, const std::vector<std::vector<int>>& lines) {
  double worst = 0;
  for (const std::vector<int>& line : lines) {
    const Vec2 &a = sheet.vertices[line.front()], &b = sheet.vertices[line.back()];
    for (int v : line) worst = std::max(worst, std::abs(cross(Vec2(b - a).normalized(), Vec2(sheet.vertices[v] - a))));
  }
  return worst;
}

TEST(Settle, ARoundedMiuraClosesAtItsGoalAndHalfWay) {
  const CreasePattern drawn = rounded(drawn_at_an_angle(miura({.columns = 4, .rows = 4})), 1e-3);
  ASSERT_GT(goal_open(drawn), 1e-5);
  const Settled settled = settle(drawn);
  ASSERT_TRUE(settled.closed);
  EXPECT_LT(goal_open(settled.sheet), 1e-12);
  ASSERT_EQ(settled.states.size(), 1U);
  EXPECT_LT(closure(real_vertices(settled.sheet), settled.states.front()).worst, 1e-12);
  EXPECT_GT(settled.states.front().cwiseAbs().minCoeff(), 0.1);
  EXPECT_LT(settled.move, 2e-3);
  EXPECT_NEAR(settled.move, (settled.sheet.vertices[settled.vertex] - drawn.vertices[settled.vertex]).norm(), 1e-15);
}

TEST(Settle, KeepsLinesStraightAndTheDrawingSymmetric) {
  const CreasePattern exact = drawn_at_an_angle(waterbomb({.columns = 4, .rows = 4}));
  const CreasePattern drawn = rounded(exact, 3e-3);
  const Settled settled = settle(drawn);
  ASSERT_TRUE(settled.closed);
  EXPECT_GT(settled.lines, 4);
  EXPECT_LT(farthest_from_a_line(settled.sheet, straight_lines(exact, 1e-9)), 1e-12);
  EXPECT_GT(settled.symmetries, 1);
  EXPECT_EQ(static_cast<int>(drawing_symmetries(settled.sheet, 1e-11).size()), settled.symmetries);
}

TEST(Settle, WhatClosesIsLeftAlone) {
  const CreasePattern sheet = diamond();
  const Settled settled = settle(sheet, {.keep_symmetry = false});
  EXPECT_TRUE(settled.closed);
  EXPECT_LT(settled.move, 1e-15);
}

TEST(Settle, OfAGoalFarFromClosingIsToldAndTheSheetIsAsItWas) {
  CreasePattern sheet = diamond();
  for (Crease& e : sheet.edges)
    if (e.assignment == Assignment::Valley) e.fold_angle = 1;
  const Settled settled = settle(sheet);
  EXPECT_FALSE(settled.closed);
  EXPECT_EQ(settled.sheet.vertices, sheet.vertices);
  EXPECT_EQ(settled.move, 0);
}

TEST(Settle, RefusesOptionsOutOfRange) {
  EXPECT_THROW(settle(miura(), {.states = -1}), InvalidOption);
  EXPECT_THROW(settle(miura(), {.drawn = 0}), InvalidOption);
  EXPECT_THROW(settle(miura(), {.most_move = 0}), InvalidOption);
  EXPECT_THROW(settle(miura(), {.tolerance = 0}), InvalidOption);
}

TEST(StraightLines, GoThroughVerticesAndKeepBordersAndCreasesApart) {
  const CreasePattern sheet = waterbomb({.columns = 2, .rows = 2});
  for (const std::vector<int>& line : straight_lines(sheet, 1e-6)) EXPECT_EQ(line.size(), 3U);
  EXPECT_TRUE(straight_lines(CreasePattern{}, 1).empty());
}

TEST(DrawingSymmetries, OfASquareTwistAreTheFourRotations) {
  const std::vector<DrawingSymmetry> group = drawing_symmetries(square_twist(), 1e-6);
  ASSERT_EQ(group.size(), 4U);
  for (const DrawingSymmetry& s : group) EXPECT_NEAR(s.turn.determinant(), 1, 1e-12);
}

TEST(DrawingSymmetries, AreExactForARoundedDrawing) {
  const CreasePattern exact = square_twist();
  const CreasePattern drawn = rounded(exact, 1e-3);
  const std::vector<DrawingSymmetry> group = drawing_symmetries(drawn, 5e-3);
  ASSERT_EQ(group.size(), 4U);
  CreasePattern symmetric = drawn;
  symmetric.vertices = symmetrized(drawn.vertices, group);
  EXPECT_EQ(drawing_symmetries(symmetric, 1e-12).size(), 4U);
}

TEST(DrawingSymmetries, OfNothingAreTheIdentity) { EXPECT_EQ(drawing_symmetries(CreasePattern{}, 1).size(), 1U); }

}  // namespace
}  // namespace plico
