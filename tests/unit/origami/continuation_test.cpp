#include "plico/origami/continuation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

TEST(Continuation, MiuraFoldsAlongItsClosedForm) {
  const MiuraOptions options{.columns = 5, .rows = 5, .zigzag_angle = radians(120)};
  const CreasePattern sheet = miura(options);
  const Configuration target = goal(make_linkage(sheet));
  const ContinuationResult found = continue_to_goal(sheet);
  ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle) << " at " << found.progress;
  EXPECT_LT(found.worst_residual, 1e-12);
  for (const Waypoint& w : found.path.waypoints) {
    const double zigzag = w.config.cwiseAbs().maxCoeff();
    for (int h = 0; h < target.size(); ++h)
      if (std::abs(target[h]) < radians(100)) {
        EXPECT_NEAR(std::abs(w.config[h]), 2 * std::atan(std::cos(options.sector) * std::tan(zigzag / 2)), 1e-9);
      }
  }
}

TEST(Continuation, WaterbombFoldsBelowItsTubeAngle) {
  const ContinuationResult found =
      continue_to_goal(waterbomb({.columns = 12, .rows = 6, .diagonal_angle = radians(48.5)}));
  EXPECT_EQ(found.ending, Ending::Found) << name(found.obstacle) << " at " << found.progress;
  EXPECT_LT(found.worst_residual, 1e-12);
}

// The sheet closes into a tube at 49.277198 degrees; beyond, its ends run into each other.
TEST(Continuation, WaterbombBeyondItsTubeAngleCollides) {
  const ContinuationResult found =
      continue_to_goal(waterbomb({.columns = 12, .rows = 6, .diagonal_angle = radians(55)}));
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_EQ(found.obstacle, Obstacle::Collision) << name(found.obstacle);
  EXPECT_GT(found.progress, 0.8);
  EXPECT_LT(found.progress, 0.95);
}

TEST(Continuation, AGoalThatDoesNotCloseIsNamedWithItsVertex) {
  CreasePattern cross = l2();
  for (Crease& crease : cross.edges) crease.fold_angle = crease.fold_angle != 0 ? kPi / 2 : 0;
  const ContinuationResult found = continue_to_goal(cross);
  EXPECT_EQ(found.obstacle, Obstacle::GoalOpen);
  EXPECT_EQ(found.vertex, 8);  // the centre
  EXPECT_GT(found.residual, 0.1);
  EXPECT_EQ(found.path.waypoints.size(), 1u);
}

TEST(Continuation, RepeatsExactly) {
  const CreasePattern sheet = waterbomb({.columns = 4, .rows = 6});
  const ContinuationResult a = continue_to_goal(sheet), b = continue_to_goal(sheet);
  ASSERT_EQ(a.ending, Ending::Found) << name(a.obstacle);
  ASSERT_EQ(a.path.waypoints.size(), b.path.waypoints.size());
  for (std::size_t i = 0; i < a.path.waypoints.size(); ++i)
    EXPECT_EQ(a.path.waypoints[i].config, b.path.waypoints[i].config);
}

}  // namespace
}  // namespace plico
