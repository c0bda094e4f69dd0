// Closed forms that hold along a whole motion, against what the continuation finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/fold/planar_faces.h"
#include "plico/origami/bases.h"
#include "plico/origami/continuation.h"
#include "plico/origami/facets.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

// Creases from one point in these directions, with these goals.
CreasePattern star(const std::vector<double>& directions, const std::vector<double>& goals) {
  CreasePattern sheet;
  const int n = static_cast<int>(directions.size());
  sheet.vertices.emplace_back(0, 0);
  for (double d : directions) sheet.vertices.emplace_back(std::cos(d), std::sin(d));
  for (int i = 0; i < n; ++i) sheet.edges.push_back({0, i + 1, assignment_of(goals[i]), goals[i]});
  for (int i = 0; i < n; ++i) sheet.edges.push_back({i + 1, (i + 1) % n + 1, Assignment::Boundary, 0});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

double scaled_half_angle(double factor, double angle) { return 2 * std::atan(factor * std::tan(angle / 2)); }

struct Sectors {
  double alpha, beta;  // between creases 1 and 2, 2 and 3; the others are their supplements
};
class FlatFoldableVertex : public testing::TestWithParam<Sectors> {
 protected:
  const double alpha_ = radians(GetParam().alpha), beta_ = radians(GetParam().beta);
  CreasePattern sheet(const std::vector<double>& goals) const {
    return star({0, alpha_, alpha_ + beta_, beta_ + kPi}, goals);
  }
};

TEST_P(FlatFoldableVertex, ModeAKeepsItsMultiplier) {
  const double p = std::sin((alpha_ - beta_) / 2) / std::sin((alpha_ + beta_) / 2), rho2 = 2.2;
  const double rho1 = scaled_half_angle(p, rho2);
  const ContinuationResult found = continue_to_goal(sheet({rho1, rho2, -rho1, rho2}));
  ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle);
  EXPECT_GE(found.path.waypoints.size(), 51u);
  for (const Waypoint& w : found.path.waypoints) {
    EXPECT_NEAR(w.config[0], scaled_half_angle(p, w.config[1]), 1e-9);
    EXPECT_NEAR(w.config[2], -w.config[0], 1e-9);
    EXPECT_NEAR(w.config[3], w.config[1], 1e-9);
  }
}

TEST_P(FlatFoldableVertex, ModeBKeepsItsMultiplier) {
  const double q = -std::cos((alpha_ + beta_) / 2) / std::cos((alpha_ - beta_) / 2), rho1 = 2.2;
  const double rho2 = scaled_half_angle(q, rho1);
  const ContinuationResult found = continue_to_goal(sheet({rho1, rho2, rho1, -rho2}));
  ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle);
  EXPECT_GE(found.path.waypoints.size(), 51u);
  for (const Waypoint& w : found.path.waypoints) {
    EXPECT_NEAR(w.config[1], scaled_half_angle(q, w.config[0]), 1e-9);
    EXPECT_NEAR(w.config[2], w.config[0], 1e-9);
    EXPECT_NEAR(w.config[3], -w.config[1], 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Sectors, FlatFoldableVertex,
                         testing::Values(Sectors{70, 100}, Sectors{110, 50}, Sectors{60, 80}, Sectors{120, 95}));

// Creases whose goals have one size.
std::vector<int> groups_by_goal(const CreasePattern& sheet) {
  std::vector<double> sizes;
  std::vector<int> groups;
  for (double angle : goal(make_linkage(sheet))) {
    const auto same = [&](double size) { return std::abs(size - std::abs(angle)) < 1e-9; };
    const auto at = std::find_if(sizes.begin(), sizes.end(), same);
    groups.push_back(static_cast<int>(at - sizes.begin()));
    if (at == sizes.end()) sizes.push_back(std::abs(angle));
  }
  return groups;
}

// All creases free, this sheet has 27 ways to move; the uniform one is what its four groups leave.
TEST(WaterbombMotion, OfFourGroupsKeepsItsRelationsAllTheWay) {
  for (double degree : {60.0, 120.0, 170.0}) {
    const CreasePattern sheet = waterbomb({.columns = 8, .rows = 10, .diagonal_angle = radians(degree)});
    const Configuration target = goal(make_linkage(sheet));
    const std::vector<RealVertex> vertices = real_vertices(sheet);
    const double d = -target.minCoeff();
    const ContinuationResult found = continue_to_goal(sheet, {.groups = groups_by_goal(sheet)});
    ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle);
    for (const Waypoint& w : found.path.waypoints) {
      EXPECT_LT(closure(vertices, w.config).worst, 1e-12);
      const double now = -w.config.minCoeff(), a = scaled_half_angle(std::sqrt(0.5), now);
      const double h = scaled_half_angle(std::sqrt(2.0), now);
      for (int c = 0; c < target.size(); ++c) {
        double expected = 2 * h - a;
        if (target[c] < 0) expected = -now;
        if (std::abs(target[c] - scaled_half_angle(std::sqrt(0.5), d)) < 1e-9) expected = a;
        if (std::abs(target[c] - scaled_half_angle(std::sqrt(2.0), d)) < 1e-9) expected = h;
        ASSERT_NEAR(w.config[c], expected, 1e-9) << "crease " << c << " at " << w.time << " to " << degree;
      }
    }
  }
}

TEST(MiuraMotion, KeepsItsRelationAllTheWayAtEverySize) {
  for (bool diagonals : {false, true}) {
    const MiuraOptions options{.columns = 24, .rows = 24, .zigzag_angle = radians(170), .facet_diagonals = diagonals};
    const CreasePattern sheet = miura(options);
    const Configuration target = goal(make_linkage(sheet));
    const ContinuationResult found = continue_to_goal(with_flat_creases_held(sheet));
    ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle);
    for (const Waypoint& w : found.path.waypoints) {
      const double zigzag = w.config.cwiseAbs().maxCoeff();
      const double straight = scaled_half_angle(std::cos(options.sector), zigzag);
      for (int c = 0; c < target.size(); ++c) {
        const double size = std::abs(target[c]) > radians(169) ? zigzag : target[c] != 0 ? straight : 0;
        ASSERT_NEAR(std::abs(w.config[c]), size, 1e-9) << "crease " << c << " at " << w.time;
      }
    }
  }
}

TEST(Continuation, SaysWhereTheSquareTwistLocks) {
  const CreasePattern sheet = square_twist();
  const std::vector<RealVertex> vertices = real_vertices(sheet);
  ASSERT_LT(closure(vertices, goal(make_linkage(sheet))).worst, 1e-12);  // the flat-folded form exists
  const ContinuationResult found = continue_to_goal(sheet);
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_TRUE(found.obstacle == Obstacle::Locked || found.obstacle == Obstacle::WrongSide) << name(found.obstacle);
  EXPECT_TRUE(
      std::any_of(vertices.begin(), vertices.end(), [&](const RealVertex& v) { return v.vertex == found.vertex; }));
  EXPECT_FALSE(describe(make_linkage(sheet), found).empty());
}

TEST(Continuation, SaysWhereAVertexIsLocked) {
  const CreasePattern sheet = star({0, kPi / 2, kPi, 1.5 * kPi}, {kPi, kPi, kPi, kPi});  // four valleys: no Maekawa
  const ContinuationResult found = continue_to_goal(sheet);
  EXPECT_EQ(found.obstacle, Obstacle::Locked) << name(found.obstacle);
  EXPECT_EQ(found.vertex, 0);
  EXPECT_GT(found.residual, 1e-4);
  EXPECT_EQ(found.frame(), 1);
  EXPECT_EQ(describe(make_linkage(sheet), found).substr(0, 51), "not rigid: locked at 0 % of the way; going on opens");
}

TEST(Continuation, StopsBeforeTheTubeCloses) {
  const CreasePattern sheet = waterbomb({.columns = 12, .rows = 12, .diagonal_angle = radians(55)});
  const ContinuationResult found = continue_to_goal(sheet, {.groups = groups_by_goal(sheet)});
  ASSERT_EQ(found.obstacle, Obstacle::Collision) << name(found.obstacle);
  const double reached = degrees(-found.path.waypoints.back().config.minCoeff());
  EXPECT_GT(reached, 49.25);
  EXPECT_LT(reached, 49.277198 + 0.03);  // the clearance of the panels lets their rims pass by that much
  EXPECT_LT(found.panels.a, found.panels.b);
  EXPECT_NE(describe(make_linkage(sheet), found).find("collides after"), std::string::npos);
}

// The same sheet, each crease within the limit that `limit_of` has for it.
template <class Limit>
CreasePattern with_limits(CreasePattern sheet, Limit limit_of) {
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (hinge[e] >= 0) sheet.edges[e].limit = limit_of(hinge[e]);
  return sheet;
}

TEST(Continuation, KeepsTheLimitsOfTheMaterial) {
  const CreasePattern sheet = miura({.columns = 6, .rows = 6});
  const auto largest = [](const ContinuationResult& found) {
    double angle = 0;
    for (const Waypoint& w : found.path.waypoints) angle = std::max(angle, w.config.cwiseAbs().maxCoeff());
    return angle;
  };
  const ContinuationResult all = continue_to_goal(with_limits(sheet, [](int) { return radians(90); }));
  ASSERT_EQ(all.ending, Ending::Found) << name(all.obstacle);
  EXPECT_LE(largest(all), radians(90));
  EXPECT_GT(largest(all), radians(30));

  const ContinuationResult one =
      continue_to_goal(with_limits(sheet, [](int h) { return h == 3 ? radians(40) : radians(90); }));
  ASSERT_EQ(one.ending, Ending::Found) << name(one.obstacle);
  for (const Waypoint& w : one.path.waypoints) EXPECT_LE(std::abs(w.config[3]), radians(40));
}

TEST(Continuation, FoldsSheetsWithoutLoopsAndSheetsWithoutCreases) {
  EXPECT_EQ(continue_to_goal(l()).ending, Ending::Found);
  EXPECT_EQ(continue_to_goal(miura({.columns = 1, .rows = 1})).ending, Ending::Found);
  EXPECT_EQ(continue_to_goal(miura({.columns = 4, .rows = 4, .zigzag_angle = 0})).ending, Ending::Found);
}

TEST(Continuation, GroupsOfDifferentGoalsAreRefused) {
  const CreasePattern sheet = miura({.zigzag_angle = radians(100)});
  EXPECT_THROW(continue_to_goal(sheet, {.groups = std::vector<int>(12, 0)}), InvalidOption);
  EXPECT_THROW(continue_to_goal(sheet, {.groups = {0, 1}}), InvalidOption);
}

TEST(Continuation, AGoalWithRoundedAnglesIsMendedWithinItsSlack) {
  CreasePattern sheet = miura({.columns = 6, .rows = 6, .zigzag_angle = radians(100)});
  for (Crease& crease : sheet.edges) crease.fold_angle = radians(std::round(100 * degrees(crease.fold_angle)) / 100);
  EXPECT_EQ(continue_to_goal(sheet).ending, Ending::Found);
  EXPECT_EQ(continue_to_goal(sheet, {.goal_slack = 0}).obstacle, Obstacle::GoalOpen);
}

// Of 272 random goals of five creases 243 are reached forward, 254 with the way back.
TEST(Continuation, UnfoldsTheGoalWhenFlatIsLeftOnAnotherBranch) {
  int forward = 0, both = 0;
  for (int seed = 1; seed <= 100; ++seed) {
    Rng rng(seed);
    std::vector<double> directions;
    for (int i = 0; i < 5; ++i) directions.push_back(2 * kPi * (i + 0.7 * rng.uniform()) / 5);
    CreasePattern sheet = star(directions, std::vector<double>(5, 0));
    Configuration start(5);
    for (int i = 0; i < 5; ++i) start[i] = 2.5 * (2 * rng.uniform() - 1);
    const Projection target = Projector(sheet).project(start);
    if (!target.closed) continue;
    for (int i = 0; i < 5; ++i) sheet.edges[i].fold_angle = target.config[i];
    forward += continue_to_goal(sheet, {.unfold_too = false}).ending == Ending::Found;
    const ContinuationResult found = continue_to_goal(sheet);
    both += found.ending == Ending::Found;
    if (!found.unfolded) continue;
    EXPECT_EQ(found.path.waypoints.front().time, 0);
    EXPECT_EQ(found.path.waypoints.front().config.norm(), 0);
    EXPECT_EQ(found.path.waypoints.back().time, 1);
    EXPECT_LT((found.path.waypoints.back().config - target.config).norm(), 1e-12);
  }
  EXPECT_GT(both, forward);
}

}  // namespace
}  // namespace plico
