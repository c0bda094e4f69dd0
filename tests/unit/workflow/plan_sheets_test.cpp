#include "plico/workflow/plan_sheets.h"

#include <gmock/gmock.h>

#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

using testing::Each;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

CreasePattern small_miura() { return miura({.columns = 3, .rows = 2, .zigzag_angle = radians(100)}); }

// Three creases at a vertex, no two of them in line: locked, and so are its triangles.
CreasePattern locked() {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {4, 0}, {2, 4}, {2, 1.5}};
  for (int i = 0; i < 3; ++i) sheet.edges.push_back({i, (i + 1) % 3, Assignment::Boundary, 0});
  for (int i = 0; i < 3; ++i) sheet.edges.push_back({3, i, Assignment::Mountain, -kPi});
  sheet.faces = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return sheet;
}

// The second sheet to the right of the first.
CreasePattern beside(CreasePattern first, const CreasePattern& second) {
  const int shift = first.num_vertices();
  for (const Vec2& p : second.vertices) first.vertices.emplace_back(p + Vec2(20, 0));
  for (Crease crease : second.edges) {
    crease.a += shift;
    crease.b += shift;
    first.edges.push_back(crease);
  }
  for (std::vector<int> face : second.faces) {
    for (int& v : face) v += shift;
    first.faces.push_back(face);
  }
  return first;
}

TEST(PlanSheets, EachFoldsToItsGoal) {
  const CreasePattern drawing = beside(small_miura(), small_miura());
  const MotionOutcome outcome = plan_sheets(drawing);
  EXPECT_EQ(outcome.ending, Ending::Found);
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.progress, 1);
  EXPECT_FALSE(outcome.sheet.has_value());
  const std::vector<Waypoint>& waypoints = outcome.motions.front().path.waypoints;
  EXPECT_EQ(waypoints.back().config, goal(make_linkage(drawing)));
  EXPECT_EQ(waypoints.back().time, 1);
}

// A strip has no loops, and its own motion two waypoints; the drawing has both.
TEST(PlanSheets, AStripFoldsBesideASheetWithLoops) {
  for (const bool strip_first : {false, true}) {
    const CreasePattern drawing = strip_first ? beside(l(), small_miura()) : beside(small_miura(), l());
    const MotionOutcome outcome = plan_sheets(drawing);
    EXPECT_EQ(outcome.ending, Ending::Found);
    EXPECT_TRUE(outcome.proven());
    EXPECT_EQ(outcome.progress, 1);
  }
}

TEST(PlanSheets, OneThatIsLockedDoesNotHoldTheOthers) {
  for (const bool first_is_locked : {false, true}) {
    const CreasePattern drawing = first_is_locked ? beside(locked(), small_miura()) : beside(small_miura(), locked());
    const MotionOutcome outcome = plan_sheets(drawing);
    EXPECT_EQ(outcome.ending, Ending::Exhausted);
    ASSERT_TRUE(outcome.proven());
    EXPECT_GT(outcome.progress, 0);
    EXPECT_LT(outcome.progress, 1);
    EXPECT_THAT(outcome.notes, Not(IsEmpty()));
    EXPECT_THAT(outcome.notes, Each(StartsWith(first_is_locked ? "sheet 1: " : "sheet 2: ")));
    const Linkage linkage = make_linkage(outcome.sheet ? *outcome.sheet : drawing);
    const Configuration end = outcome.motions.front().path.waypoints.back().config;
    int at_goal = 0;
    for (int h = 0; h < linkage.num_hinges(); ++h)
      at_goal += linkage.hinges[h].target != 0 && std::abs(end[h] - linkage.hinges[h].target) < 1e-12;
    EXPECT_EQ(at_goal, make_linkage(small_miura()).num_hinges());
  }
}

TEST(PlanSheets, CutPanelsAreThoseOfTheDrawing) {
  CreasePattern twist = square_twist();
  const CreasePattern drawing = beside(twist, small_miura());
  const MotionOutcome outcome = plan_sheets(drawing);
  ASSERT_TRUE(outcome.proven());
  ASSERT_TRUE(outcome.sheet.has_value());
  ASSERT_EQ(static_cast<int>(outcome.bends.size()), drawing.num_faces());
  for (int f = twist.num_faces(); f < drawing.num_faces(); ++f) EXPECT_EQ(outcome.bends[f], 0);
  for (int e = 0; e < drawing.num_edges(); ++e) {
    EXPECT_EQ(outcome.sheet->edges[e].a, drawing.edges[e].a);
    EXPECT_EQ(outcome.sheet->edges[e].b, drawing.edges[e].b);
  }
}

}  // namespace
}  // namespace plico
