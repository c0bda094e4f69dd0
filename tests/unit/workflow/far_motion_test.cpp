#include "plico/workflow/far_motion.h"

#include <gtest/gtest.h>

#include "plico/origami/continuation.h"
#include "plico/origami/patterns.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

CreasePattern tube() { return waterbomb({.columns = 12, .rows = 4, .diagonal_angle = radians(55)}); }

FoldingPath planned(const Linkage& linkage, bool check_collisions) {
  ContinuationOptions options;
  options.check_collisions = check_collisions;
  return continue_to_goal(linkage, options).path;
}

FoldingPath part_until(const FoldingPath& path, double time) {
  FoldingPath part;
  for (const Waypoint& w : path.waypoints)
    if (w.time <= time) part.waypoints.push_back(w);
  const double last = part.waypoints.back().time;
  for (Waypoint& w : part.waypoints) w.time /= last;
  return part;
}

// A proof looks at time from its beginning on: what a number of looks came to is shown, on every machine the same.
TEST(FarMotion, AProofThatEndsEarlyHasShownThePartBefore) {
  const Linkage linkage = make_linkage(miura({.columns = 4, .rows = 4}));
  const FoldingPath path = refine_path(linkage, planned(linkage, true), 0.2 * default_clearance(linkage));
  const PathProof whole = prove_path(linkage, path);
  ASSERT_EQ(whole.verdict, PathVerdict::Free);
  EXPECT_EQ(whole.free_until, 1);
  PathProofOptions few;
  few.max_looks = (whole.pair_intervals + whole.intervals * linkage.num_panels()) / 2;
  const PathProof begun = prove_path(linkage, path, few), again = prove_path(linkage, path, few);
  EXPECT_EQ(begun.verdict, PathVerdict::Undecided);
  EXPECT_TRUE(begun.interrupted);
  EXPECT_EQ(begun.free_until, again.free_until);
  ASSERT_GT(begun.free_until, path.waypoints[1].time);
  EXPECT_LT(begun.free_until, 1);
  EXPECT_EQ(prove_path(linkage, part_until(path, begun.free_until)).verdict, PathVerdict::Free);
}

// Planned without a look at collisions, the sheet runs through itself where its tube closes: at 49.28 degrees.
TEST(FarMotion, KeepsThePartOfAMotionThatCanBeProven) {
  const Linkage linkage = make_linkage(tube());
  const Motion motion =
      prove_as_far(linkage, planned(linkage, false), MotionMethod::Continuation, default_clearance(linkage));
  ASSERT_EQ(motion.proof.verdict, PathVerdict::Free);
  EXPECT_EQ(motion.path.waypoints.back().time, 1);
  EXPECT_NEAR(share_of_way(linkage, motion.path.waypoints.back().config), 49.28 / 55, 0.03);
  EXPECT_EQ(prove_path(linkage, motion.path).verdict, PathVerdict::Free);
}

TEST(FarMotion, WithoutTimeThereIsNoMotion) {
  const Linkage linkage = make_linkage(tube());
  const Motion motion = prove_as_far(linkage, planned(linkage, true), MotionMethod::Continuation,
                                     default_clearance(linkage), limited({}, 0));
  EXPECT_LT(motion.path.waypoints.size(), 2u);
  EXPECT_NE(motion.proof.verdict, PathVerdict::Free);
}

TEST(FarMotion, AShareOfTheTimeIsAskedOfADeadlineOnly) {
  EXPECT_FALSE(share_of_time({}, 0.5).deadline.has_value());
  const plico::Run run = limited({}, 1000);
  const plico::Run half = share_of_time(run, 0.5);
  EXPECT_GT(*run.deadline - *half.deadline, std::chrono::seconds(490));
  EXPECT_LT(*run.deadline - *half.deadline, std::chrono::seconds(510));
}

}  // namespace
}  // namespace plico
