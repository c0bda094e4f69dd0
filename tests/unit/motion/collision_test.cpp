#include "plico/motion/collision.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/motion/penetration.h"

namespace plico {
namespace {

Configuration angles(std::initializer_list<double> values) {
  Configuration config(static_cast<int>(values.size()));
  int i = 0;
  for (double v : values) config[i++] = v;
  return config;
}

TEST(Collision, FlatSheetIsFree) {
  const Linkage linkage = make_linkage(square_strip({1, 1, 1, 1}));
  EXPECT_FALSE(CollisionChecker(linkage).collides(flat(linkage)));
}

TEST(Collision, FourSquaresCloseABoxAndThenCrossIt) {
  const Linkage linkage = make_linkage(square_strip({kPi / 2, kPi / 2, kPi / 2}));
  CollisionChecker checker(linkage);
  EXPECT_FALSE(checker.collides(goal(linkage)));
  EXPECT_EQ(checker.collisions(1.1 * goal(linkage)), (std::vector<PanelPair>{{0, 3}}));
}

TEST(Collision, LayersLyingOnEachOtherTouch) {
  const Linkage linkage = make_linkage(square_strip({kPi, -kPi, kPi, -kPi}));
  EXPECT_FALSE(CollisionChecker(linkage).collides(goal(linkage)));
}

TEST(Collision, AHingeTurnedBeyondAHalfTurnCollides) {
  const Linkage linkage = make_linkage(square_strip({1}));
  CollisionChecker checker(linkage);
  EXPECT_FALSE(checker.collides(angles({kPi})));
  EXPECT_TRUE(checker.collides(angles({kPi + 0.01})));
}

TEST(Collision, AnswersDoNotDependOnEarlierOnes) {
  const Linkage linkage = make_linkage(square_strip({2, 2, 2, 2, 2}));
  CollisionChecker used(linkage);
  Rng rng(3);
  for (int i = 0; i < 200; ++i) {
    Configuration config(5);
    for (double& angle : config) angle = rng.uniform(-kPi, kPi);
    CollisionChecker fresh(linkage);
    const auto pairs = fresh.collisions(config);
    EXPECT_EQ(used.collisions(config), pairs);
    EXPECT_EQ(used.collides(config), !pairs.empty());
  }
}

TEST(Collision, PartsDoNotMeet) {
  CreasePattern sheet = square_strip({kPi / 2, kPi / 2, 0, kPi / 2, kPi / 2});
  sheet.edges.erase(sheet.edges.begin() + 2);
  for (std::size_t v = 8; v < sheet.vertices.size(); ++v) sheet.vertices[v].x() -= 2;  // laid over each other
  const Linkage linkage = make_linkage(sheet);
  EXPECT_FALSE(CollisionChecker(linkage).collides(goal(linkage)));
}

TEST(Collision, BadClearanceIsRefused) {
  const Linkage linkage = make_linkage(square_strip({1}));
  EXPECT_THROW(CollisionChecker(linkage, {.clearance = -1}), InvalidOption);
}

struct Triangle {
  Vec3 corners[3];
  PlacedPlate plate() const { return {corners, 3, (corners[1] - corners[0]).cross(corners[2] - corners[0])}; }
};

TEST(Penetration, TouchingIsNotPenetrating) {
  const Triangle ground{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  const Triangle standing{{{0.5, 0.5, 0}, {0.7, 0.5, 1}, {0.3, 0.5, 1}}};  // on its corner
  const Triangle piercing{{{0.5, 0.5, -0.1}, {0.7, 0.5, 1}, {0.3, 0.5, 1}}};
  const Triangle lying{{{0.1, 0.1, 0}, {0.5, 0.1, 0}, {0.1, 0.5, 0}}};  // inside, in the same plane
  const Triangle beside{{{3, 3, -1}, {4, 3, 1}, {3, 4, 1}}};
  EXPECT_FALSE(penetrate(ground.plate(), standing.plate(), 1e-9));
  EXPECT_TRUE(penetrate(ground.plate(), piercing.plate(), 1e-9));
  EXPECT_FALSE(penetrate(ground.plate(), piercing.plate(), 0.2));
  EXPECT_FALSE(penetrate(ground.plate(), lying.plate(), 1e-9));
  EXPECT_FALSE(penetrate(ground.plate(), beside.plate(), 1e-9));
}

}  // namespace
}  // namespace plico
