#include "plico/origami/pattern_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "plico/fold/planar_faces.h"
#include "plico/origami/bases.h"
#include "plico/origami/named_patterns.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Spoke {
  double degrees, goal;
};

// Creases from the centre of a regular 360-gon's circle, all of it the border.
CreasePattern wheel(const std::vector<Spoke>& spokes) {
  CreasePattern sheet;
  for (int i = 0; i < 360; ++i) {
    sheet.vertices.emplace_back(std::cos(radians(i)), std::sin(radians(i)));
    sheet.edges.push_back({i, (i + 1) % 360, Assignment::Boundary, 0});
  }
  sheet.vertices.emplace_back(0, 0);
  for (const Spoke& spoke : spokes)
    sheet.edges.push_back(
        {360, static_cast<int>(spoke.degrees), assignment_of(radians(spoke.goal)), radians(spoke.goal)});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

// A unit square and more edges between more points; no panels, as they may not exist.
CreasePattern drawing(const std::vector<Vec2>& more_points, const std::vector<std::array<int, 2>>& creases) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  sheet.vertices.insert(sheet.vertices.end(), more_points.begin(), more_points.end());
  for (int i = 0; i < 4; ++i) sheet.edges.push_back({i, (i + 1) % 4, Assignment::Boundary, 0});
  for (const auto& [a, b] : creases) sheet.edges.push_back({a, b, Assignment::Valley, kPi});
  return sheet;
}

const PatternProblem* find(const PatternReport& report, const std::string& code) {
  const auto found = std::ranges::find(report.problems, code, &PatternProblem::code);
  return found == report.problems.end() ? nullptr : &*found;
}

TEST(PatternCheck, NamedPatternsHaveNeitherErrorsNorWarnings) {
  for (const NamedPattern& pattern : named_patterns()) {
    const PatternReport report = check_pattern(make_pattern(pattern.name));
    for (const PatternProblem& problem : report.problems)
      EXPECT_EQ(problem.severity, Severity::Note) << pattern.name << ": " << problem.message;
  }
}

TEST(PatternCheck, ACrossingIsNamedWithItsPlace) {
  const PatternReport report = check_pattern(drawing({}, {{0, 2}, {1, 3}}));
  const PatternProblem* problem = find(report, "origami/crossing");
  ASSERT_TRUE(problem);
  EXPECT_FALSE(report.usable());
  EXPECT_THAT(problem->edges, ElementsAre(4, 5));
  EXPECT_THAT(problem->where, HasSubstr("near 0.5 0.5"));
  EXPECT_FALSE(problem->suggestion.empty());
  EXPECT_EQ(report.problems.size(), 1u);
}

TEST(PatternCheck, AnEndOnAnotherEdgeIsATJunction) {
  const PatternReport report = check_pattern(drawing({{0.5, 0}}, {{4, 2}}));
  const PatternProblem* problem = find(report, "origami/t-junction");
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->edges, ElementsAre(0, 4));
  EXPECT_THAT(problem->where, HasSubstr("near 0.5 0"));
}

TEST(PatternCheck, EdgesOnEachOtherAreAnOverlap) {
  const PatternReport twice = check_pattern(drawing({}, {{0, 2}, {2, 0}}));
  ASSERT_TRUE(find(twice, "origami/overlap"));
  EXPECT_THAT(find(twice, "origami/overlap")->edges, ElementsAre(4, 5));
  EXPECT_TRUE(find(check_pattern(drawing({{0.5, 0.5}}, {{0, 2}, {0, 4}})), "origami/overlap"));
  EXPECT_TRUE(find(check_pattern(drawing({{0.25, 0}, {0.75, 0}}, {{4, 5}})), "origami/overlap"));
}

TEST(PatternCheck, EdgesWithoutLengthAndVerticesInOnePlace) {
  EXPECT_TRUE(find(check_pattern(drawing({{0.5, 0.5}, {0.5, 0.5}}, {{4, 5}})), "origami/edge-length"));
  CreasePattern doubled = diamond();
  doubled.vertices.push_back(doubled.vertices[8]);
  const PatternReport report = check_pattern(doubled);
  ASSERT_TRUE(find(report, "origami/duplicate-vertex"));
  EXPECT_THAT(find(report, "origami/duplicate-vertex")->vertices, ElementsAre(8, 9));
  EXPECT_TRUE(find(report, "origami/unused-vertex"));
}

TEST(PatternCheck, ADanglingCreaseIsNamedWithItsFreeEnd) {
  CreasePattern sheet = drawing({{0.5, 0.25}}, {{0, 2}, {1, 4}});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  const PatternReport report = check_pattern(sheet);
  ASSERT_TRUE(find(report, "origami/dangling"));
  EXPECT_THAT(find(report, "origami/dangling")->message, HasSubstr("at vertex 4"));
  EXPECT_THAT(find(report, "origami/dangling")->where, HasSubstr("near 0.5 0.25"));
}

TEST(PatternCheck, KawasakiAndMaekawaWarnOnlyWhereTheGoalIsFlat) {
  const PatternReport skew = check_pattern(wheel({{0, 180}, {80, 180}, {180, -180}, {270, 180}}));
  ASSERT_TRUE(find(skew, "origami/kawasaki"));
  EXPECT_EQ(find(skew, "origami/kawasaki")->severity, Severity::Warning);
  EXPECT_THAT(find(skew, "origami/kawasaki")->message, HasSubstr("misses 180 degrees by 10,"));
  EXPECT_THAT(find(skew, "origami/kawasaki")->where, HasSubstr("vertex 360 near 0 0"));
  EXPECT_TRUE(find(skew, "origami/goal-open"));

  const PatternReport even = check_pattern(wheel({{0, 180}, {90, -180}, {180, 180}, {270, -180}}));
  ASSERT_TRUE(find(even, "origami/maekawa"));
  EXPECT_EQ(find(even, "origami/maekawa")->severity, Severity::Warning);
  EXPECT_FALSE(find(even, "origami/kawasaki"));

  const PatternReport bent = check_pattern(wheel({{0, 10}, {80, 10}, {180, -10}, {270, -10}}));
  EXPECT_EQ(find(bent, "origami/kawasaki")->severity, Severity::Note);
  EXPECT_EQ(find(bent, "origami/maekawa")->severity, Severity::Note);
  EXPECT_THAT(find(check_pattern(box1()), "origami/kawasaki")->message, HasSubstr("5 creases, must be even"));
}

TEST(PatternCheck, FlatCreasesTakeNoPartInKawasaki) {
  const std::vector<VertexFacts> facts = vertex_facts(wheel({{0, 180}, {30, 0}, {90, 180}, {180, -180}, {270, 180}}));
  ASSERT_EQ(facts.size(), 1u);
  EXPECT_NEAR(facts[0].kawasaki, 0, 1e-12);
  EXPECT_EQ(facts[0].edges.size(), 5u);
  EXPECT_TRUE(facts[0].flat_folded);
  EXPECT_EQ(facts[0].valleys, 3);
}

TEST(PatternCheck, UpToThreeCreasesLockUnlessTwoAreInLine) {
  const auto locks = [](const std::vector<Spoke>& spokes) {
    return find(check_pattern(wheel(spokes)), "origami/locked-vertex") != nullptr;
  };
  EXPECT_TRUE(locks({{0, 90}, {120, 90}, {240, 90}}));
  EXPECT_TRUE(locks({{0, 90}, {100, 90}}));
  EXPECT_FALSE(locks({{0, 90}, {180, 90}}));
  EXPECT_FALSE(locks({{0, 90}, {60, 0}, {180, 90}}));
  EXPECT_FALSE(locks({{0, 90}, {90, 180}, {180, -90}, {270, 180}}));
}

TEST(PatternCheck, GoalsMustSuitTheirAssignment) {
  CreasePattern sheet = miura({.columns = 3, .rows = 3, .zigzag_angle = 1});
  sheet.edges[0].fold_angle *= -1;
  const PatternReport report = check_pattern(sheet);
  ASSERT_TRUE(find(report, "origami/assignment"));
  EXPECT_THAT(find(report, "origami/assignment")->edges, ElementsAre(0));
  ASSERT_TRUE(find(report, "origami/goal-open"));
  EXPECT_GT(find(report, "origami/goal-open")->vertices[0], 0);
  sheet.edges[0].fold_angle = 4;
  EXPECT_FALSE(check_pattern(sheet).usable());
}

TEST(PatternCheck, SectorsGoAroundEveryRealVertex) {
  for (const VertexFacts& facts : vertex_facts(miura({.columns = 4, .rows = 4, .sector = radians(65)}))) {
    double sum = 0;
    for (double sector : facts.sectors) {
      EXPECT_LT(std::min(std::abs(sector - radians(65)), std::abs(sector - radians(115))), 1e-12);
      sum += sector;
    }
    EXPECT_NEAR(sum, 2 * kPi, 1e-12);
    EXPECT_EQ(std::abs(facts.mountains - facts.valleys), 2);
    EXPECT_LT(facts.kawasaki, 1e-12);
  }
}

// Two equations a vertex; each independent in a tessellation.
TEST(PatternCheck, FirstOrderMotionsOfTheFlatSheet) {
  EXPECT_EQ(num_first_order_motions(l()), 2);
  EXPECT_EQ(num_first_order_motions(l2()), 2);
  EXPECT_EQ(num_first_order_motions(waterbomb_base()), 6);
  EXPECT_EQ(num_first_order_motions(miura({.columns = 5, .rows = 5})), 40 - 2 * 16);
}

}  // namespace
}  // namespace plico
