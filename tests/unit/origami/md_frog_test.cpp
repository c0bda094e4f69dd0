#include "plico/origami/md_frog.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/fold/folding_order.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

// Waypoints from flat to the goal that close, do not collide and do not jump.
void expect_folds(const CreasePattern& sheet, const MdFrogPath& planned) {
  const Linkage linkage = make_linkage(sheet);
  const auto vertices = real_vertices(sheet);
  CollisionChecker checker(linkage);
  const auto& waypoints = planned.path.waypoints;
  ASSERT_GE(waypoints.size(), 2);
  EXPECT_TRUE(waypoints.front().config.isZero());
  EXPECT_EQ(waypoints.back().config, goal(linkage));
  EXPECT_EQ(waypoints.front().time, 0);
  EXPECT_EQ(waypoints.back().time, 1);
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    EXPECT_LT(closure(vertices, waypoints[i].config).worst, 1e-9);
    EXPECT_FALSE(checker.collides(waypoints[i].config));
    if (i > 0) {
      EXPECT_GT(waypoints[i].time, waypoints[i - 1].time);
    }
  }
  EXPECT_EQ(planned.connections.size() + 1, planned.states.size());
}

TEST(MdFrog, FoldsThePatternsOfTable31) {
  for (const CreasePattern& sheet : {l(), l2(), waterbomb_base(), diamond(), box1(), box2(), fly1(), fly2(), miura()}) {
    const MdFrogResult result = md_frog(sheet);
    ASSERT_EQ(result.ending, Ending::Found);
    expect_folds(sheet, result.paths.front());
    EXPECT_EQ(prove_path(make_linkage(sheet), result.paths.front().path).verdict, PathVerdict::Free);
  }
}

// The straight way through the closed configurations collides: it takes the states in between.
TEST(MdFrog, FoldsTheSailboatInOrder) {
  const MdFrogResult result = md_frog(sailboat());
  ASSERT_EQ(result.ending, Ending::Found);
  expect_folds(sailboat(), result.paths.front());
  EXPECT_GT(result.paths.front().states.size(), 2);
}

TEST(MdFrog, FoldsOneLineOfL2AfterTheOther) {
  const CreasePattern sheet = l2();
  const MdFrogResult result = md_frog(sheet);
  ASSERT_EQ(result.ending, Ending::Found);
  const auto order = folding_order(result.paths.front().path);
  ASSERT_EQ(order.size(), 2);
  EXPECT_EQ(order[0].hinges.size(), 2);
  EXPECT_EQ(order[1].hinges.size(), 2);
  EXPECT_NE(order[0].hinges, order[1].hinges);
  EXPECT_EQ(order[0].to, order[1].from);
}

TEST(MdFrog, PassesTheStatesOfTheUser) {
  const CreasePattern sheet = l2();
  Configuration second_line = Configuration::Zero(4);  // the line that folds by 90 degrees, folded by 180 first
  second_line[1] = kPi;
  second_line[3] = -kPi;
  const Configuration target = goal(make_linkage(sheet));
  ASSERT_NEAR(std::abs(target[1]), kPi / 2, 1e-15);
  second_line[1] = std::copysign(kPi, target[1]);
  second_line[3] = second_line[1];
  if (closure(real_vertices(sheet), second_line).worst > 1e-9) second_line[3] = -second_line[1];
  const MdFrogResult result = md_frog(sheet, {.intermediate = {second_line}});
  ASSERT_EQ(result.ending, Ending::Found);
  const auto& states = result.paths.front().states;
  EXPECT_NE(std::find(states.begin(), states.end(), second_line), states.end());
}

// Two flaps that overlap on the panel between them: folded together they cross, so one is on top.
CreasePattern overlapping_flaps() {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {0.7, 0}, {1.7, 0}, {2.4, 0}, {2.4, 1}, {1.7, 1}, {0.7, 1}, {0, 1}};
  for (int v = 0; v < 8; ++v) sheet.edges.push_back({v, (v + 1) % 8, Assignment::Boundary, 0});
  sheet.edges.push_back({1, 6, Assignment::Valley, kPi});
  sheet.edges.push_back({2, 5, Assignment::Valley, kPi});
  sheet.faces = {{0, 1, 6, 7}, {1, 2, 5, 6}, {2, 3, 4, 5}};
  return sheet;
}

TEST(MdFrog, AlternativesDoNotBlendIntoEachOther) {
  const MdFrogResult result = md_frog(overlapping_flaps(), {.alternatives = 2});
  ASSERT_EQ(result.ending, Ending::Found);
  ASSERT_EQ(result.paths.size(), 2);
  for (const MdFrogPath& path : result.paths) expect_folds(overlapping_flaps(), path);
  EXPECT_NE(folding_order(result.paths[0].path).front().hinges, folding_order(result.paths[1].path).front().hinges);
}

// The line of 90 degrees cannot be first: its halves fold to opposite sides.
TEST(MdFrog, SaysWhenThereIsNoOtherWay) {
  const MdFrogResult result = md_frog(l2(), {.alternatives = 2});
  EXPECT_EQ(result.ending, Ending::Exhausted);
  EXPECT_EQ(result.paths.size(), 1);
}

TEST(MdFrog, StopsThatAreOneAndTheSameArePassedAtOnce) {
  const Configuration target = goal(make_linkage(l2()));
  const MdFrogResult twice = md_frog(l2(), {.intermediate = {target, target}});
  ASSERT_EQ(twice.ending, Ending::Found);
  EXPECT_EQ(twice.paths[0].states.back(), target);
  CreasePattern still = l2();
  for (Crease& crease : still.edges) crease.fold_angle = 0;
  const MdFrogResult flat = md_frog(still);
  ASSERT_EQ(flat.ending, Ending::Found);
  EXPECT_EQ(flat.paths[0].states.size(), 1u);
  EXPECT_EQ(flat.paths[0].path.waypoints.size(), 2u);
}

TEST(MdFrog, RefusesAGoalThatDoesNotClose) {
  CreasePattern sheet = waterbomb_base();
  sheet.edges.front().fold_angle = 1;
  EXPECT_THROW(md_frog(sheet), InvalidInput);
  EXPECT_THROW(md_frog(l2(), {.alternatives = 0}), InvalidOption);
}

TEST(MdFrog, StopsWhenTheRunIsOver) {
  const MdFrogResult result = md_frog(sailboat(), {}, limited({}, 0));
  EXPECT_EQ(result.ending, Ending::TimedOut);
  EXPECT_TRUE(result.paths.empty());
}

TEST(FoldingOrder, MergesStretchesOfTheSameCreases) {
  const auto config = [](double a, double b) { return Configuration(Eigen::Vector2d(a, b)); };
  const FoldingPath path{
      {{0, config(0, 0)}, {0.2, config(1, 0)}, {0.5, config(2, 0)}, {0.7, config(2, 0)}, {1, config(2, 3)}}};
  const auto order = folding_order(path);
  ASSERT_EQ(order.size(), 2);
  EXPECT_EQ(order[0].hinges, std::vector<int>{0});
  EXPECT_EQ(order[0].from, 0);
  EXPECT_EQ(order[0].to, 0.5);
  EXPECT_EQ(order[0].angles, std::vector<double>{2});
  EXPECT_EQ(order[1].hinges, std::vector<int>{1});
  EXPECT_EQ(order[1].from, 0.7);
}

TEST(MdFrog, RefusesAGoalAndAStateBeyondALimit) {
  CreasePattern sheet = l2();
  const Configuration target = goal(make_linkage(sheet));
  for (Crease& crease : sheet.edges) crease.limit = radians(60);
  EXPECT_THROW(md_frog(sheet), InvalidInput);
  for (Crease& crease : sheet.edges) crease.fold_angle = 0;
  EXPECT_THROW(md_frog(sheet, {.intermediate = {target}}), InvalidInput);
}

TEST(MdFrog, LooksAtEverySampleOfALinearConnection) {
  for (const int samples : {1, 20, 32}) {
    const MdFrogResult found = md_frog(l(), {.linear_samples = samples});
    EXPECT_EQ(found.ending, Ending::Found);
    EXPECT_EQ(found.samples, samples * found.connections_tried);
  }
}

}  // namespace
}  // namespace plico
