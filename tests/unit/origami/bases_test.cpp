#include "plico/origami/bases.h"

#include <gtest/gtest.h>

#include <random>

#include "plico/motion/collision.h"
#include "plico/origami/closure.h"
#include "plico/origami/continuation.h"

namespace plico {
namespace {

struct Base {
  const char* name;
  CreasePattern sheet;
  int real_vertices, creases, panels;
};

std::vector<Base> bases() {
  return {{"l", l(), 0, 2, 3},
          {"l2", l2(), 1, 4, 4},
          {"waterbomb", waterbomb_base(), 1, 8, 8},
          {"diamond", diamond(), 1, 6, 6},
          {"box1", box1(), 1, 5, 5},
          {"box2", box2(), 2, 9, 8},
          {"fly1", fly1(), 1, 8, 8},
          {"fly2", fly2(), 2, 11, 10},
          {"sailboat", sailboat(), 13, 32, 20},
          {"plane", plane(), 1, 5, 5},
          {"square twist", square_twist(), 4, 12, 9},
          {"letter", letter(), 2, 7, 6}};
}

TEST(Bases, HaveTheCountsOfTable31) {
  for (const Base& base : bases()) {
    EXPECT_EQ(real_vertices(base.sheet).size(), base.real_vertices) << base.name;
    EXPECT_EQ(make_linkage(base.sheet).num_hinges(), base.creases) << base.name;
    EXPECT_EQ(base.sheet.num_faces(), base.panels) << base.name;
  }
}

TEST(Bases, GoalsClose) {
  for (const Base& base : bases())
    EXPECT_LT(closure(real_vertices(base.sheet), goal(make_linkage(base.sheet))).worst, 1e-12) << base.name;
}

// The multipliers around the inner square do not come to 1 ([Evans, Lang, Magleby, Howell 2015] on twists).
TEST(Bases, TheSquareTwistDoesNotFoldRigidly) {
  const CreasePattern sheet = square_twist();
  const ContinuationResult found = continue_to_goal(sheet, {.check_collisions = false});
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_TRUE(found.obstacle == Obstacle::Locked || found.obstacle == Obstacle::WrongSide) << name(found.obstacle);
  EXPECT_TRUE(found.vertex >= 0 || found.hinge >= 0);
}

// Nor does any foldable state beyond flat keep its mountains and valleys: wherever a projection starts, it comes out
// flat or with a crease on the wrong side. The same trial finds such states of the waterbomb base.
int num_states_on_the_right_sides(const CreasePattern& sheet) {
  const Configuration target = goal(make_linkage(sheet));
  const std::vector<RealVertex> vertices = real_vertices(sheet);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0.05, 0.6);
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Configuration start = target;
    for (double& angle : start) angle *= part(random);
    const Projection projection = project(vertices, start);
    const Eigen::ArrayXd folded = projection.config.array() * target.array().sign();
    if (projection.closed && (folded > 0.01).all() && !(folded > kPi - 0.01).all()) ++found;
  }
  return found;
}

TEST(Bases, NoStateOfTheSquareTwistKeepsItsAssignment) {
  EXPECT_EQ(num_states_on_the_right_sides(square_twist()), 0);
  EXPECT_GT(num_states_on_the_right_sides(waterbomb_base()), 50);
}

struct LetterFolds {
  double left, right, bend;  // as parts of their goals
};

Configuration letter_state(const LetterFolds& folds) {
  const CreasePattern sheet = letter();
  Configuration config = goal(make_linkage(sheet));
  const std::vector<double> part = {folds.left, folds.left, folds.right, folds.right,
                                    folds.bend, folds.bend, folds.bend};
  for (int h = 0; h < config.size(); ++h) config[h] *= part[h];
  return config;
}

TEST(Bases, TheLetterTearsWhenAllIsFoldedAtOnce) {
  double worst = 0;
  for (int i = 1; i < 100; ++i)
    worst = std::max(worst, closure(real_vertices(letter()), letter_state({i / 100., i / 100., i / 100.})).worst);
  EXPECT_GT(worst, radians(60));
  const ContinuationResult straight = continue_to_goal(letter());
  EXPECT_EQ(straight.ending, Ending::Exhausted);
  EXPECT_EQ(straight.obstacle, Obstacle::Collision) << name(straight.obstacle);
}

TEST(Bases, TheLetterFoldsInOrder) {
  const CreasePattern sheet = letter();
  const Linkage linkage = make_linkage(sheet);
  CollisionChecker checker(linkage);
  const auto expect_good = [&](const LetterFolds& folds) {
    const Configuration config = letter_state(folds);
    EXPECT_LT(closure(real_vertices(sheet), config).worst, 1e-12) << folds.left << folds.right << folds.bend;
    EXPECT_FALSE(checker.collides(config)) << folds.left << " " << folds.right << " " << folds.bend;
  };
  for (int i = 0; i <= 20; ++i) {
    expect_good({i / 20., 0, 0});
    expect_good({1, i / 20., 0});
    expect_good({1, 1, i / 20.});
  }
  EXPECT_TRUE(checker.collides(letter_state({0.8, 0.8, 0})));  // both flaps at once
}

}  // namespace
}  // namespace plico
