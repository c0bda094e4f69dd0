#include "plico/origami/approach.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/facets.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

// One goal of a Miura asks for what the closed form does not give.
CreasePattern miura_with_a_wrong_goal() {
  CreasePattern sheet = miura({.columns = 3, .rows = 3, .zigzag_angle = radians(100)});
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (hinge[e] == 0) sheet.edges[e].fold_angle *= 0.5;
  return sheet;
}

TEST(Approach, ReachesAGoalThatCloses) {
  const CreasePattern sheet = miura({.columns = 3, .rows = 3, .zigzag_angle = radians(100)});
  const ContinuationResult found = approach_goal(sheet, {});
  EXPECT_EQ(found.ending, Ending::Found);
  EXPECT_EQ(found.progress, 1);
  const Configuration off = found.path.waypoints.back().config - goal(make_linkage(sheet));
  EXPECT_EQ(off.cwiseAbs().maxCoeff(), 0);
}

TEST(Approach, ComesNearestToAGoalThatStaysOpen) {
  const CreasePattern sheet = miura_with_a_wrong_goal();
  const Linkage linkage = make_linkage(sheet);
  const ContinuationResult found = approach_goal(sheet, {});
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_EQ(found.obstacle, Obstacle::GoalOpen);
  EXPECT_GT(found.progress, 0.6);
  const std::vector<RealVertex> loops = real_vertices(sheet);
  double last = -1;
  for (const Waypoint& w : found.path.waypoints) {
    EXPECT_LT(closure(loops, w.config).worst, 1e-12);
    EXPECT_GT(share_of_way(linkage, w.config), last);
    last = share_of_way(linkage, w.config);
  }
}

TEST(Approach, OfASquareTwistNeedsFacets) {
  const CreasePattern sheet = square_twist();
  EXPECT_LT(approach_goal(sheet, {}).progress, 0.01);
  EXPECT_GT(approach_goal(cut_into_facets(sheet).sheet, {}).progress, 0.5);
}

TEST(Approach, RefusesOptionsOutOfRange) {
  EXPECT_THROW(approach_goal(miura(), {}, {.frames = 0}), InvalidOption);
  EXPECT_THROW(approach_goal(miura(), {}, {.facet_weight = 0}), InvalidOption);
}

}  // namespace
}  // namespace plico
