// Random drawings on a small integer grid, where whether edges meet can be decided by whole numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "plico/fold/planar_faces.h"
#include "plico/origami/pattern_check.h"

namespace plico {
namespace {

CreasePattern random_drawing(std::mt19937& random, int edges) {
  std::uniform_int_distribution<int> at(0, 12);
  CreasePattern sheet;
  std::set<std::pair<int, int>> used;
  while (sheet.num_vertices() < 2 * edges) {
    const int x = at(random), y = at(random);
    if (used.emplace(x, y).second) sheet.vertices.emplace_back(x, y);
  }
  std::uniform_int_distribution<int> vertex(0, sheet.num_vertices() - 1);
  while (sheet.num_edges() < edges) {
    const int a = vertex(random), b = vertex(random);
    if (a != b) sheet.edges.push_back({a, b, Assignment::Valley, 1});
  }
  return sheet;
}

long side(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 u = b - a, v = p - a;
  const long twice_area = std::lround(u.x() * v.y() - u.y() * v.x());
  return (twice_area > 0) - (twice_area < 0);
}

bool strictly_inside(const Vec2& a, const Vec2& b, const Vec2& p) {
  return side(a, b, p) == 0 && (p - a).dot(p - b) < 0;
}

// Do the edges share a point that is not an end of both?
bool clash(const CreasePattern& sheet, const Crease& e, const Crease& f) {
  const Vec2 &a = sheet.vertices[e.a], &b = sheet.vertices[e.b], &c = sheet.vertices[f.a], &d = sheet.vertices[f.b];
  if (std::minmax(e.a, e.b) == std::minmax(f.a, f.b)) return true;
  if (strictly_inside(a, b, c) || strictly_inside(a, b, d) || strictly_inside(c, d, a) || strictly_inside(c, d, b))
    return true;
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

TEST(PatternCheckLaws, EveryClashAndNoOtherIsFound) {
  std::mt19937 random(20170501);
  for (int round = 0; round < 300; ++round) {
    const CreasePattern sheet = random_drawing(random, 2 + round % 12);
    std::vector<std::pair<int, int>> expected;
    for (int e = 0; e < sheet.num_edges(); ++e)
      for (int f = e + 1; f < sheet.num_edges(); ++f)
        if (clash(sheet, sheet.edges[e], sheet.edges[f])) expected.emplace_back(e, f);
    EXPECT_EQ(clashing_edges(sheet.vertices, sheet.edges), expected) << "round " << round;
    std::vector<std::pair<int, int>> reported;
    for (const PatternProblem& problem : check_pattern(sheet).problems)
      if (problem.severity == Severity::Error) reported.emplace_back(problem.edges.at(0), problem.edges.at(1));
    std::ranges::sort(reported);
    EXPECT_EQ(reported, expected) << "round " << round;
  }
}

// The place that is named lies on both edges.
TEST(PatternCheckLaws, ClashesAreWhereTheySay) {
  std::mt19937 random(7);
  const auto distance = [](const Vec2& p, const Vec2& a, const Vec2& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (a + t * (b - a) - p).norm();
  };
  for (int round = 0; round < 200; ++round) {
    const CreasePattern sheet = random_drawing(random, 8);
    for (const auto& [e, f] : clashing_edges(sheet.vertices, sheet.edges)) {
      const Vec2 at = meeting_point(sheet.vertices, sheet.edges[e], sheet.edges[f]);
      for (const Crease& edge : {sheet.edges[e], sheet.edges[f]})
        EXPECT_LT(distance(at, sheet.vertices[edge.a], sheet.vertices[edge.b]), 1e-9) << "round " << round;
    }
  }
}

// A plane drawing that leads to panels is never called an error.
TEST(PatternCheckLaws, WhatHasPanelsIsUsable) {
  std::mt19937 random(11);
  int plane = 0;
  for (int round = 0; round < 400; ++round) {
    CreasePattern sheet = random_drawing(random, 4);
    if (!clashing_edges(sheet.vertices, sheet.edges).empty()) continue;
    ++plane;
    sheet.faces = planar_faces(sheet.vertices, sheet.edges);
    EXPECT_TRUE(check_pattern(sheet).usable()) << "round " << round;
  }
  EXPECT_GT(plane, 20);
}

}  // namespace
}  // namespace plico
