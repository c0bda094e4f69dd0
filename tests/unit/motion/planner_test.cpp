#include "plico/motion/planner.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/motion/collision.h"

namespace plico {
namespace {

// Folded together at one rate, the long end runs into the first squares; closed from the far end, it does not.
Linkage spiral() { return make_linkage(square_strip({1.0, 1.3, 1.55, 1.57})); }

class EveryPlanner : public testing::TestWithParam<Planner> {};

TEST_P(EveryPlanner, ReachesTheGoalThroughFreeStates) {
  const Linkage linkage = spiral();
  const PlannedPath planned = plan_path(linkage, {.planner = GetParam()}, limited({}, 10));
  ASSERT_EQ(planned.ending, Ending::Found);
  EXPECT_TRUE(planned.path.at(0).isZero());
  EXPECT_TRUE(planned.path.at(1).isApprox(goal(linkage)));
  EXPECT_GT(planned.states_checked, 0);
  CollisionChecker checker(linkage);
  for (int i = 0; i <= 200; ++i) EXPECT_FALSE(checker.collides(planned.path.at(i / 200.0))) << i;
}

TEST_P(EveryPlanner, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const Linkage linkage = make_linkage(square_strip({3, 3, 3, 3, 3, 3}));
  const PlannedPath planned = plan_path(linkage, {.planner = GetParam()}, {.stop = source.get_token()});
  EXPECT_NE(planned.ending, Ending::TimedOut);
}

TEST_P(EveryPlanner, GivesUpAfterSoManyStates) {
  const Linkage linkage = spiral();
  const PlannedPath planned = plan_path(linkage, {.planner = GetParam(), .max_states = 3});
  EXPECT_EQ(planned.ending, Ending::Exhausted);
  EXPECT_EQ(planned.states_checked, 3);
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlanner, testing::Values(Planner::LazyPrm, Planner::Prm, Planner::RrtConnect));

TEST(Planner, KnowsThatACollidingGoalHasNoPath) {
  const Linkage linkage = make_linkage(square_strip({1.7, 1.7, 1.7}));  // the last square crosses the first
  EXPECT_EQ(plan_path(linkage, {}, limited({}, 5)).ending, Ending::Exhausted);
}

TEST(Planner, AStraightMotionBlendsWithItself) {
  const Linkage linkage = make_linkage(square_strip({1, 1, 1}));
  EXPECT_TRUE(blends_freely(linkage, linear_path(linkage), uniform_path(linkage)));
}

TEST(Planner, ValidRatioIsOneForAConvexFan) {
  const Linkage linkage = make_linkage(square_strip({1, 1, 1}));
  const ValidRatio ratio = valid_ratio(linkage, 50);
  EXPECT_EQ(ratio.discrete, 1);
  EXPECT_EQ(ratio.uniform, 1);
}

TEST(Planner, OptionsAreChecked) {
  EXPECT_THROW(check(PlannerOptions{.resolution = 0}), InvalidOption);
  EXPECT_THROW(check(PlannerOptions{.max_states = -1}), InvalidOption);
  EXPECT_THROW(valid_ratio(spiral(), 0), InvalidOption);
}

}  // namespace
}  // namespace plico
