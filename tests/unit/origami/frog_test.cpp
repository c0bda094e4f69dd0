#include "plico/origami/frog.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

void expect_folds(const CreasePattern& sheet, const FrogOptions& options = {}) {
  const FrogResult found = frog(sheet, options);
  ASSERT_EQ(found.ending, Ending::Found) << "still " << found.distance << " away";
  const auto& waypoints = found.path.waypoints;
  EXPECT_TRUE(waypoints.front().config.isZero());
  EXPECT_EQ(waypoints.back().config, goal(make_linkage(sheet)));
  EXPECT_EQ(waypoints.back().time, 1);
  EXPECT_LE(found.counts.valid, found.counts.sampled);
  EXPECT_LE(static_cast<long>(waypoints.size()), found.counts.valid + 2);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    EXPECT_GT(waypoints[i].time, waypoints[i - 1].time);
    EXPECT_LE((waypoints[i].config - waypoints[i - 1].config).norm(), 2 * options.step);
    EXPECT_LE(closure(real_vertices(sheet), waypoints[i].config).worst, found.worst_residual + 1e-15);
  }
}

TEST(Frog, FoldsASheetWithoutLoops) { expect_folds(l()); }
TEST(Frog, FoldsOneLineAfterTheOther) { expect_folds(l2()); }
TEST(Frog, FoldsTheCornerOfABox) { expect_folds(box1()); }
TEST(Frog, FoldsTwoCornersOfABox) { expect_folds(box2()); }
TEST(Frog, FoldsTheDiamond) { expect_folds(diamond()); }
TEST(Frog, FoldsTheWaterbombBase) { expect_folds(waterbomb_base()); }
TEST(Frog, FoldsTheFlies) {
  expect_folds(fly1());
  expect_folds(fly2());
}
TEST(Frog, FoldsTheMiura) { expect_folds(miura()); }

TEST(Frog, FoldsWithTheMinimizationOfTheDissertation) {
  FrogOptions options{.find = FindFoldable::Nlopt};
  expect_folds(box1(), options);
  options.nlopt.algorithm = NloptAlgorithm::Slsqp;
  expect_folds(box1(), options);
}

TEST(Frog, RepeatsForTheSameSeed) {
  const FrogResult a = frog(waterbomb_base()), b = frog(waterbomb_base());
  ASSERT_EQ(a.path.waypoints.size(), b.path.waypoints.size());
  for (std::size_t i = 0; i < a.path.waypoints.size(); ++i)
    EXPECT_EQ(a.path.waypoints[i].config, b.path.waypoints[i].config);
  EXPECT_EQ(a.counts.tested, b.counts.tested);
}

TEST(Frog, SaysHonestlyThatItDidNotGetThere) {
  const FrogResult few = frog(miura(), {.max_samples = 5});
  EXPECT_EQ(few.ending, Ending::Exhausted);
  EXPECT_EQ(few.counts.sampled, 5);
  EXPECT_GT(few.distance, 1);

  CreasePattern open = l2();
  for (Crease& crease : open.edges) crease.fold_angle /= 2;
  const FrogResult never = frog(open);
  EXPECT_EQ(never.ending, Ending::Exhausted);
  EXPECT_EQ(never.counts.sampled, 0);

  const plico::Run over = limited({}, 0);
  EXPECT_EQ(frog(miura(), {}, over).ending, Ending::TimedOut);
}

TEST(Frog, OptionsAreChecked) {
  EXPECT_THROW(frog(l2(), {.step = 0}), InvalidOption);
  EXPECT_THROW(frog(l2(), {.initial_weight = 2}), InvalidOption);
  EXPECT_THROW(frog(l2(), {.max_samples = 0}), InvalidOption);
}

TEST(Frog, KeepsTheLimitsOfTheHingesWithBothProjections) {
  CreasePattern sheet = miura({.zigzag_angle = radians(100)});
  const double widest = goal(make_linkage(sheet)).cwiseAbs().maxCoeff();
  for (const FindFoldable find : {FindFoldable::GaussNewton, FindFoldable::Nlopt}) {
    for (Crease& crease : sheet.edges) crease.limit = widest;
    const FrogResult found = frog(sheet, {.max_samples = 5, .find = find});
    EXPECT_GT(found.path.waypoints.size(), 1u);
    EXPECT_EQ(waypoint_beyond_limits(make_linkage(sheet), found.path), -1);
    for (Crease& crease : sheet.edges) crease.limit = 0.9 * widest;
    const FrogResult never = frog(sheet, {.find = find});
    EXPECT_EQ(never.ending, Ending::Exhausted);
    EXPECT_EQ(never.counts.sampled, 0);
  }
}

}  // namespace
}  // namespace plico
