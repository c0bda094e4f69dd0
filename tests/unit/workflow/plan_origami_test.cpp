#include "plico/workflow/plan_origami.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/closure.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

CreasePattern limited_to(CreasePattern sheet, double most) {
  for (Crease& crease : sheet.edges) crease.limit = most;
  return sheet;
}

using testing::MatchesRegex;
using testing::StartsWith;

TEST(PlanOrigami, EveryMotionIsProvenAndOpensByAFifthOfTheClearance) {
  for (const auto& [name, sheet] :
       std::vector<std::pair<const char*, CreasePattern>>{{"l2", l2()},
                                                          {"waterbomb base", waterbomb_base()},
                                                          {"diamond", diamond()},
                                                          {"box2", box2()},
                                                          {"fly2", fly2()},
                                                          {"flat miura", miura({.columns = 4, .rows = 5})},
                                                          {"waterbomb", waterbomb({.columns = 6, .rows = 4})}}) {
    SCOPED_TRACE(name);
    const MotionOutcome outcome = plan_origami(sheet);
    ASSERT_EQ(outcome.ending, Ending::Found);
    ASSERT_TRUE(outcome.proven());
    const PathProof& proof = outcome.motions.front().proof;
    EXPECT_LE(proof.loops.gap, 0.2 * proof.clearance);
    EXPECT_LT(proof.loops.residual, 1e-11);
    EXPECT_TRUE(outcome.notes.empty());
    const Configuration end = outcome.motions.front().path.waypoints.back().config;
    EXPECT_LT((end - goal(make_linkage(sheet))).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

TEST(PlanOrigami, RefinedWaypointsCloseAndKeepTheGivenOnes) {
  const CreasePattern sheet = miura({.zigzag_angle = radians(100)});
  const Linkage linkage = make_linkage(sheet);
  FoldingPath path;
  path.waypoints = {{0, goal(make_linkage(miura({.zigzag_angle = radians(60)})))}, {1, goal(linkage)}};
  const FoldingPath refined = refine_path(make_linkage(sheet), path, 1e-4);
  EXPECT_GT(refined.waypoints.size(), 10u);
  EXPECT_LE(SheetMotion(linkage, refined).loops().gap, 1e-4);
  EXPECT_EQ(refined.waypoints.front().config, path.waypoints.front().config);
  EXPECT_EQ(refined.waypoints.back().config, path.waypoints.back().config);
  for (const Waypoint& w : refined.waypoints) EXPECT_LT(closure(real_vertices(sheet), w.config).worst, 1e-12);
}

TEST(PlanOrigami, AGoalThatIsNotRigidGetsItsVertexAndTheWayToTheNearestState) {
  CreasePattern cross = l2();
  for (Crease& crease : cross.edges) crease.fold_angle = crease.fold_angle != 0 ? kPi / 2 : 0;
  const MotionOutcome outcome = plan_origami(cross);
  EXPECT_EQ(outcome.ending, Ending::Exhausted);
  ASSERT_TRUE(outcome.proven());
  EXPECT_GT(outcome.progress, 0.3);
  EXPECT_LT(outcome.progress, 1);
  ASSERT_TRUE(outcome.sheet.has_value());  // its panels were cut
  EXPECT_EQ(static_cast<int>(outcome.bends.size()), cross.num_faces());
  EXPECT_THAT(outcome.notes.front(), StartsWith("not rigid: the goal stays open by"));
}

// The straight way ends where the tube closes; from there its ends slide along each other.
TEST(PlanOrigami, WhatCollidesStraightOnSlidesAlongAsFarAsItGoes) {
  const MotionOutcome outcome = plan_origami(waterbomb({.columns = 12, .rows = 4, .diagonal_angle = radians(55)}));
  EXPECT_EQ(outcome.ending, Ending::Exhausted);
  ASSERT_TRUE(outcome.proven());
  EXPECT_GT(outcome.progress, 49.28 / 55);
  EXPECT_LT(outcome.progress, 1);
  EXPECT_EQ(outcome.motions.front().path.waypoints.back().time, 1);
  EXPECT_THAT(outcome.notes.front(), StartsWith("collides after"));
  EXPECT_THAT(outcome.notes, testing::Contains(StartsWith("the goal collides with itself")));
}

// All creases at once lead the letter's outer thirds, and the sailboat's flaps, through each other.
TEST(PlanOrigami, WhatIsBlockedStraightOnIsFoldedInAnotherOrder) {
  const MotionOutcome outcome = plan_origami(letter());
  EXPECT_EQ(outcome.ending, Ending::Found);
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.motions.front().method, MotionMethod::MdFrog);
  ASSERT_EQ(outcome.notes.size(), 1u);
  EXPECT_THAT(outcome.notes.front(), MatchesRegex("folding order: 2 creases .*, then 2 creases .*, then 3 creases .*"));
  const Configuration end = outcome.motions.front().path.waypoints.back().config;
  EXPECT_LT((end - goal(make_linkage(letter()))).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_EQ(plan_origami(letter(), {.method = MotionMethod::Continuation}).ending, Ending::Exhausted);
}

TEST(PlanOrigami, TheSailboatFolds) {
  const MotionOutcome outcome = plan_origami(sailboat());
  EXPECT_EQ(outcome.ending, Ending::Found);
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.motions.front().method, MotionMethod::MdFrog);
}

TEST(PlanOrigami, TheDissertationsPlannersAreProvenLikeOurs) {
  for (const MotionMethod method : {MotionMethod::Frog, MotionMethod::MdFrog})
    for (const CreasePattern& sheet : {l2(), diamond(), box1(), miura({.columns = 4, .rows = 4})}) {
      const MotionOutcome outcome = plan_origami(sheet, {.method = method});
      EXPECT_EQ(outcome.ending, Ending::Found);
      ASSERT_TRUE(outcome.proven());
      EXPECT_EQ(outcome.motions.front().method, method);
    }
}

TEST(PlanOrigami, AGoalThatCollidesIsNotSearchedFor) {
  const CreasePattern tube = waterbomb({.columns = 12, .rows = 4, .diagonal_angle = radians(55)});
  for (const MotionMethod method : {MotionMethod::Frog, MotionMethod::MdFrog}) {
    const MotionOutcome outcome = plan_origami(tube, {.method = method});
    EXPECT_EQ(outcome.ending, Ending::Exhausted);
    EXPECT_TRUE(outcome.motions.empty());
    ASSERT_EQ(outcome.notes.size(), 1u);
    EXPECT_THAT(outcome.notes.front(), StartsWith("the goal collides with itself: panels"));
  }
}

TEST(PlanOrigami, AMotionPlannedInGroupsFoldsALargerTessellation) {
  const auto sheet = [](int columns, int rows) {
    return waterbomb({.columns = columns, .rows = rows, .diagonal_angle = radians(40)});
  };
  const MotionOutcome few = plan_origami(sheet(4, 6), {.grouped = true});
  ASSERT_TRUE(few.proven());
  EXPECT_EQ(few.notes.front(), "planned with 4 crease groups and 3 of 15 vertices");
  const MotionOutcome many =
      reuse_motion(make_linkage(sheet(4, 6)), few.motions.front().path, make_linkage(sheet(8, 10)));
  EXPECT_EQ(many.ending, Ending::Found);
  ASSERT_TRUE(many.proven());
  EXPECT_EQ(many.motions.front().method, MotionMethod::Reuse);
  const Configuration end = many.motions.front().path.waypoints.back().config;
  EXPECT_LT((end - goal(make_linkage(sheet(8, 10)))).lpNorm<Eigen::Infinity>(), 1e-9);
  // Half of the way is no way to the goal.
  FoldingPath half = few.motions.front().path;
  half.waypoints.resize(half.waypoints.size() / 2);
  for (Waypoint& w : half.waypoints) w.time /= half.waypoints.back().time;
  const MotionOutcome cut = reuse_motion(make_linkage(sheet(4, 6)), half, make_linkage(sheet(8, 10)));
  EXPECT_EQ(cut.ending, Ending::Exhausted);
  EXPECT_THAT(cut.notes.front(), MatchesRegex("the motion given ends .* degrees short of the goal"));
}

TEST(PlanOrigami, PassesTheStatesAskedFor) {
  Configuration first = Configuration::Zero(7);
  first.head<2>().setConstant(kPi);
  const MotionOutcome outcome = plan_origami(letter(), {.through = {first}});
  ASSERT_TRUE(outcome.proven());
  const std::vector<Waypoint>& waypoints = outcome.motions.front().path.waypoints;
  EXPECT_TRUE(std::any_of(waypoints.begin(), waypoints.end(),
                          [&](const Waypoint& w) { return (w.config - first).lpNorm<Eigen::Infinity>() < 1e-9; }));
  EXPECT_THROW(plan_origami(letter(), {.method = MotionMethod::Frog, .through = {first}}), InvalidOption);
  EXPECT_THROW(plan_origami(letter(), {.method = MotionMethod::Frog, .grouped = true}), InvalidOption);
}

TEST(PlanOrigami, RoundedGoalsAreMovedToTheNearestThatCloses) {
  CreasePattern sheet = miura({.zigzag_angle = radians(100)});
  for (Crease& crease : sheet.edges) crease.fold_angle = radians(std::round(10 * degrees(crease.fold_angle)) / 10);
  const MotionOutcome outcome = plan_origami(sheet);
  EXPECT_EQ(outcome.ending, Ending::Found);
  EXPECT_THAT(outcome.notes.front(), StartsWith("goal angles moved by up to 0.0"));
}

TEST(PlanOrigami, StopsWhereTheMaterialDoes) {
  const CreasePattern sheet = limited_to(miura({.zigzag_angle = radians(120)}), radians(90));
  const MotionOutcome outcome = plan_origami(sheet);
  EXPECT_EQ(outcome.ending, Ending::Exhausted);
  ASSERT_TRUE(outcome.proven());
  EXPECT_THAT(outcome.notes.front(), StartsWith("limited: the goal folds"));
  double largest = 0;
  for (const Waypoint& w : outcome.motions.front().path.waypoints)
    largest = std::max(largest, w.config.lpNorm<Eigen::Infinity>());
  EXPECT_LE(largest, radians(90) + 1e-9);
  EXPECT_GT(largest, radians(85));
  EXPECT_EQ(plan_origami(limited_to(sheet, radians(121))).ending, Ending::Found);
}

// All goals are within their limits; the least limit of any crease is below the goals of others.
TEST(PlanOrigami, ALimitBindsItsOwnCreaseOnly) {
  CreasePattern sheet = letter();
  for (Crease& crease : sheet.edges)
    if (std::abs(crease.fold_angle) <= radians(95)) crease.limit = radians(95);
  for (const MotionMethod method : {MotionMethod::Auto, MotionMethod::MdFrog}) {
    const MotionOutcome outcome = plan_origami(sheet, {.method = method});
    EXPECT_EQ(outcome.ending, Ending::Found) << name(method);
    EXPECT_TRUE(outcome.proven()) << name(method);
  }
}

// Four squares around a vertex, folded along one line by 90 degrees; the other line, which stays flat, could turn
// by 10.
TEST(PlanOrigami, ALimitOnCreasesThatStayFlatChangesNothing) {
  CreasePattern cross;
  cross.vertices = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  cross.faces = {{0, 1, 8, 7}, {1, 2, 3, 8}, {8, 3, 4, 5}, {7, 8, 5, 6}};
  cross.edges = {{8, 1, Assignment::Flat, 0, radians(10)},
                 {8, 3, Assignment::Valley, radians(90)},
                 {8, 5, Assignment::Flat, 0, radians(10)},
                 {8, 7, Assignment::Valley, radians(90)}};
  for (int v = 0; v < 8; ++v) cross.edges.push_back({v, (v + 1) % 8, Assignment::Boundary});
  for (const MotionMethod method : {MotionMethod::Auto, MotionMethod::Continuation, MotionMethod::MdFrog}) {
    const MotionOutcome outcome = plan_origami(cross, {.method = method});
    EXPECT_EQ(outcome.ending, Ending::Found) << name(method);
    ASSERT_TRUE(outcome.proven()) << name(method);
    EXPECT_NEAR(outcome.motions.front().path.waypoints.back().config.maxCoeff(), radians(90), 1e-6) << name(method);
  }
}

// One contract for all planners: within the limits they plan, beyond they stop before them or refuse.
TEST(PlanOrigami, EveryPlannerHonoursLimits) {
  const CreasePattern within = limited_to(l2(), kPi), beyond = limited_to(l2(), radians(60));
  for (const MotionMethod method :
       {MotionMethod::Auto, MotionMethod::Continuation, MotionMethod::Frog, MotionMethod::MdFrog}) {
    EXPECT_EQ(plan_origami(within, {.method = method}).ending, Ending::Found) << name(method);
    const MotionOutcome outcome = plan_origami(beyond, {.method = method});
    EXPECT_EQ(outcome.ending, Ending::Exhausted) << name(method);
    for (const Motion& motion : outcome.motions)
      for (const Waypoint& w : motion.path.waypoints)
        EXPECT_LT(w.config.lpNorm<Eigen::Infinity>(), radians(60) + 1e-6) << name(method);
  }
  const Linkage strip = make_linkage(limited_to(l(), radians(60)));
  for (const MotionMethod method : {MotionMethod::Auto, MotionMethod::Linear, MotionMethod::Uniform,
                                    MotionMethod::LazyPrm, MotionMethod::RrtConnect, MotionMethod::Prm}) {
    EXPECT_THROW(plan(strip, {.method = method}), InvalidInput) << name(method);
    EXPECT_TRUE(plan(make_linkage(l()), {.method = method}, limited({}, 20)).proven()) << name(method);
  }
}

TEST(PlanOrigami, GroupsGoAsFarAsTheSheetDoes) {
  const CreasePattern sheet = waterbomb({.columns = 12, .rows = 6, .diagonal_angle = radians(60)});
  const MotionOutcome outcome = plan_origami(sheet, {.method = MotionMethod::Continuation, .grouped = true});
  EXPECT_EQ(outcome.ending, Ending::Exhausted);
  EXPECT_TRUE(outcome.proven());
  EXPECT_GT(outcome.progress, 0.8);
  EXPECT_LT(outcome.progress, 1);
  EXPECT_THAT(outcome.notes, testing::Contains(StartsWith("collides after")));
}

TEST(PlanOrigami, OptionsAreChecked) {
  EXPECT_THROW(plan_origami(miura(), {.method = MotionMethod::LazyPrm}), InvalidOption);
  EXPECT_THROW(plan_origami(miura(), {.waypoints = 0}), InvalidOption);
  EXPECT_THROW(refine_path(make_linkage(miura()), {}, 0), InvalidOption);
}

TEST(PlanOrigami, OutOfTimeIsSaid) {
  const MotionOutcome outcome = plan_origami(miura({.columns = 8, .rows = 8}), {}, limited({}, 0));
  EXPECT_EQ(outcome.ending, Ending::TimedOut);
}

}  // namespace
}  // namespace plico
