#include "plico/workflow/plan_motion.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/error.h"

namespace plico {
namespace {

TEST(PlanMotion, TakesTheStraightMotionWhenItIsFree) {
  const Linkage linkage = make_linkage(square_strip({1, 1, 1}));
  const MotionOutcome outcome = plan(linkage);
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.ending, Ending::Found);
  EXPECT_EQ(outcome.motions.front().method, MotionMethod::Linear);
}

TEST(PlanMotion, HandsOutTheBestWhenNothingFolds) {
  const Linkage linkage = make_linkage(square_strip({1.7, 1.7, 1.7}));
  const MotionOutcome outcome = plan(linkage, {}, limited({}, 5));
  EXPECT_EQ(outcome.ending, Ending::Exhausted);
  ASSERT_EQ(outcome.motions.size(), 1u);
  EXPECT_FALSE(outcome.proven());
  EXPECT_EQ(outcome.motions.front().proof.verdict, PathVerdict::Collides);
}

TEST(PlanMotion, OutOfTimeStillJudgesWhatItHandsOut) {
  const Linkage linkage = make_linkage(square_strip({1.7, 1.7, 1.7}));
  const MotionOutcome outcome = plan(linkage, {.method = MotionMethod::LazyPrm}, limited({}, 0));
  EXPECT_EQ(outcome.ending, Ending::TimedOut);
  EXPECT_EQ(outcome.motions.front().proof.verdict, PathVerdict::Collides);
}

TEST(PlanMotion, NamesAndOptionsAreChecked) {
  for (const std::string& name : motion_methods()) EXPECT_NO_THROW(motion_method(name));
  EXPECT_THROW(motion_method("magic"), InvalidOption);
  EXPECT_THROW(plan(make_linkage(square_strip({1})), {.alternatives = 0}), InvalidOption);
}

TEST(FoldWithNoise, ExactCreasesFoldAndCrowdedOnesDoNot) {
  const Linkage roomy = make_linkage(square_strip({1, 1}));
  EXPECT_EQ(fold_with_noise(roomy, linear_path(roomy), 0.1, 20).folded, 20);
  const double right = kPi / 2;
  const Linkage box = make_linkage(square_strip({right, right, right}));
  EXPECT_EQ(fold_with_noise(box, linear_path(box), 0, 5).folded, 5);
  const NoiseVerdict noisy = fold_with_noise(box, linear_path(box), 0.1, 40);
  EXPECT_GT(noisy.folded, 0);
  EXPECT_LT(noisy.folded, 40);
  EXPECT_LT(noisy.mean_stop, 1);
}

}  // namespace
}  // namespace plico
