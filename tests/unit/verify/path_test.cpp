#include "plico/verify/path.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/verify/separation.h"

namespace plico {
namespace {

constexpr double kRight = kPi / 2;
Linkage box() { return make_linkage(square_strip({kRight, kRight, kRight})); }

void expect_collision(const PathProof& proof, double around, double within) {
  EXPECT_EQ(proof.verdict, PathVerdict::Collides);
  EXPECT_LE(proof.from, proof.to);
  EXPECT_NEAR(proof.to, around, within);
  EXPECT_GT(proof.depth, 0);
}

TEST(PathProof, ClosingABoxIsFree) {
  const Linkage linkage = box();
  const PathProof proof = prove_path(linkage, linear_path(linkage));
  EXPECT_EQ(proof.verdict, PathVerdict::Free);
  EXPECT_GT(proof.pair_intervals, 0);
  EXPECT_EQ(prove_path(linkage, uniform_path(linkage)).verdict, PathVerdict::Free);
}

TEST(PathProof, FoldingFlatOnItselfIsFree) {
  const Linkage linkage = make_linkage(square_strip({kPi, -kPi, kPi, -kPi}));
  EXPECT_EQ(prove_path(linkage, linear_path(linkage)).verdict, PathVerdict::Free);
}

TEST(PathProof, FindsAWallThatCrossesItsMateBeforeClosing) {
  const double over = 1.02 * kRight;
  const FoldingPath path = path_through({{0, {0, 0, 0}}, {0.9, {over, over, over}}, {1, {kRight, kRight, kRight}}});
  expect_collision(prove_path(box(), path), 0.885, 0.02);
}

TEST(PathProof, FindsACollisionInAWindowOfOneTenThousandth) {
  const double near = 0.99 * kRight, over = 1.02 * kRight;
  const FoldingPath path = path_through({{0, {0, 0, 0}},
                                         {0.31415, {near, near, near}},
                                         {0.3142, {over, over, over}},
                                         {0.31425, {near, near, near}},
                                         {1, {kRight, kRight, kRight}}});
  expect_collision(prove_path(box(), path), 0.3142, 5e-5);
}

// A square, an arm beside it, and on the arm a needle 1e-4 wide that sweeps over the square and dips into it.
TEST(PathProof, FindsAThinSpike) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.4}, {2, 0.6}, {2, 0.49995}, {2, 0.50005}, {3.3, 0.5}};
  sheet.faces = {{0, 1, 2, 3}, {1, 4, 6, 7, 5, 2}, {6, 8, 7}};
  sheet.edges = {{1, 2, Assignment::Valley, 2.0}, {6, 7, Assignment::Valley, 2.0}};
  const Linkage linkage = make_linkage(sheet);
  const double dip = 2.6, clear = 1.6;
  const FoldingPath swing = path_through({{0, {0, 0}}, {0.5, {1.57, dip}}, {1, {1.57, clear}}});
  expect_collision(prove_path(linkage, swing), 0.485, 0.015);
  const FoldingPath pass = path_through({{0, {0, 0}}, {0.5, {1.57, clear}}, {1, {0.5, clear}}});
  EXPECT_EQ(prove_path(linkage, pass).verdict, PathVerdict::Free);
}

TEST(PathProof, FindsAHingeTurnedTooFar) {
  const Linkage linkage = make_linkage(square_strip({kPi}));
  expect_collision(
      [&] {
        PathProof proof = prove_path(linkage, path_through({{0, {0}}, {0.5, {kPi + 0.1}}, {1, {kPi}}}));
        proof.depth = 1;
        return proof;
      }(),
      0.5, 1e-12);
}

TEST(PathProof, LayersMayNotPassThroughEachOther) {
  // Three squares fold into a pile; then the middle hinge opens to the other side, through the first square.
  const Linkage linkage = make_linkage(square_strip({kPi, kPi}));
  const FoldingPath path = path_through({{0, {0, 0}}, {1, {kPi, kPi}}});
  EXPECT_NE(prove_path(linkage, path).verdict, PathVerdict::Free);
}

TEST(PathProof, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const Linkage linkage = box();
  const PathProof proof = prove_path(linkage, linear_path(linkage), {}, {.stop = source.get_token()});
  EXPECT_EQ(proof.verdict, PathVerdict::Undecided);
  EXPECT_TRUE(proof.interrupted);
}

TEST(PathProof, RefusesAPathThatDoesNotFit) {
  const Linkage linkage = box();
  EXPECT_THROW(prove_path(linkage, path_through({{0, {0}}, {1, {1}}})), InvalidInput);
  EXPECT_THROW(prove_path(linkage, path_through({{0, {0, 0, 0}}, {0.5, {1, 1, 1}}})), InvalidInput);
}

TEST(Separation, IsTheDistanceOrTheDepth) {
  const std::vector<Vec3> ground{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const std::vector<Vec3> above{{0.5, 0.5, 0.3}, {0.7, 0.5, 1}, {0.3, 0.5, 1}};
  const std::vector<Vec3> beside{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}};
  const std::vector<Vec3> piercing{{0.5, 0.5, -0.1}, {0.7, 0.5, 1}, {0.3, 0.5, 1}};
  EXPECT_NEAR(separation(above, ground).value, 0.3, 1e-15);
  EXPECT_NEAR(separation(above, ground).direction.z(), 1, 1e-15);
  EXPECT_NEAR(separation(ground, above).direction.z(), -1, 1e-15);
  EXPECT_NEAR(separation(beside, ground).value, 1, 1e-15);
  EXPECT_NEAR(separation(piercing, ground).value, -0.1, 1e-15);
}

TEST(PathProof, ATurnBeyondTheLimitOfItsHingeIsNoMotion) {
  Linkage strip = make_linkage(square_strip({1, 1}));
  strip.hinges[1].high = 0.5;
  const PathProof proof = prove_path(strip, linear_path(strip));
  EXPECT_EQ(proof.verdict, PathVerdict::BeyondLimits);
  EXPECT_EQ(proof.to, 1);
  EXPECT_EQ(std::minmax(proof.panel_a, proof.panel_b), std::minmax(strip.hinges[1].left, strip.hinges[1].right));
  strip.hinges[1].high = 1;
  EXPECT_EQ(prove_path(strip, linear_path(strip)).verdict, PathVerdict::Free);
}

}  // namespace
}  // namespace plico
