// Chains of thick panels: what the collision check and the proof say about them, against a test of boxes written apart.
#include <gtest/gtest.h>

#include <optional>

#include "effort.h"
#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/motion/collision.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

constexpr double kThickness = 0.2;

// Squares in a row, thick, hinges on the front (offset > 0) or the back where they are to turn up or down.
Linkage chain(const std::vector<double>& angles, const std::vector<double>& offset, double thickness = kThickness) {
  return thickened(make_linkage(square_strip(angles)), thickness, offset);
}

// ---- Brute force: boxes as centre, three axes and half sizes -------------------------------------------------------

struct Box {
  Vec3 center;
  Eigen::Matrix3d axes;
  Vec3 half;
};

// Gottschalk, Lin, Manocha, OBBTree, 1996: the axis that separates most decides; positive: apart by that much.
double gap(const Box& a, const Box& b) {
  const Vec3 between = b.center - a.center;
  double most = -1e30;
  const auto try_axis = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (length < 1e-7) return;
    double reach = 0;
    for (int k = 0; k < 3; ++k)
      reach += a.half[k] * std::abs(a.axes.col(k).dot(axis)) + b.half[k] * std::abs(b.axes.col(k).dot(axis));
    most = std::max(most, (std::abs(between.dot(axis)) - reach) / length);
  };
  for (int i = 0; i < 3; ++i) {
    try_axis(a.axes.col(i));
    try_axis(b.axes.col(i));
    for (int j = 0; j < 3; ++j) try_axis(a.axes.col(i).cross(b.axes.col(j)));
  }
  return most;
}

// The deepest penetration over all pairs of the squares' boxes, shrunk by the clearance at their sides.
double deepest(const Linkage& linkage, const Configuration& config, double clearance) {
  const std::vector<Pose> poses = folding_map(linkage, config);
  std::vector<Box> boxes;
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const Vec3 center = (linkage.panels[p][0] + linkage.panels[p][2]) / 2;
    boxes.push_back(
        {poses[p] * center, poses[p].linear(), Vec3(0.5 - clearance, 0.5 - clearance, linkage.thickness / 2)});
  }
  double depth = -1e30;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((boxes[i].center - boxes[j].center).squaredNorm() > 2.1) continue;
      depth = std::max(depth, -gap(boxes[i], boxes[j]));
    }
  }
  return depth;
}

std::optional<double> first_collision(const Linkage& linkage, const FoldingPath& path, double clearance, double touch,
                                      int samples) {
  for (int i = 0; i <= samples; ++i)
    if (const double t = static_cast<double>(i) / samples; deepest(linkage, path.at(t), clearance) > touch) return t;
  return {};
}

FoldingPath straight(const Linkage& linkage) { return {{{0, flat(linkage)}, {1, goal(linkage)}}}; }

// ---- Laws ----------------------------------------------------------------------------------------------------------

TEST(ThickPanelLaw, HingesOnAlternateSidesLetAStackFoldFlat) {
  std::vector<double> angles, offset;
  for (int h = 0; h < 7; ++h) {
    angles.push_back(h % 2 ? -kPi : kPi);
    offset.push_back(h % 2 ? -kThickness / 2 : kThickness / 2);
  }
  const Linkage stack = chain(angles, offset);
  EXPECT_EQ(prove_path(stack, straight(stack)).verdict, PathVerdict::Free);
  EXPECT_FALSE(CollisionChecker(stack).collides(goal(stack)));
  // Eight panels on each other, each one thickness farther up than the one before.
  const std::vector<Pose> poses = folding_map(stack, goal(stack));
  for (int p = 1; p < stack.num_panels(); ++p) {
    const auto height = [&](int panel) { return (poses[panel] * stack.panels[panel][0]).z(); };
    EXPECT_NEAR(std::abs(height(p) - height(p - 1)), kThickness, 1e-12);
  }
}

TEST(ThickPanelLaw, HingesInTheMidPlaneDoNot) {
  const Linkage stack = chain({kPi, -kPi, kPi, -kPi, kPi, -kPi, kPi}, {});
  EXPECT_EQ(prove_path(stack, straight(stack)).verdict, PathVerdict::Collides);
  EXPECT_TRUE(CollisionChecker(stack).collides(goal(stack)));
}

TEST(ThickPanelLaw, AHingeOnTheFrontTurnsUpButNotDown) {
  for (const double angle : {0.1, 1.0, 2.0, kPi}) {
    const Linkage up = chain({angle}, {kThickness / 2}), down = chain({-angle}, {kThickness / 2});
    EXPECT_EQ(prove_path(up, straight(up)).verdict, PathVerdict::Free) << angle;
    EXPECT_EQ(prove_path(down, straight(down)).verdict, PathVerdict::Collides) << angle;
  }
}

TEST(ThickPanelLaw, ThicknessAndOffsetsAreWithinRange) {
  const Linkage two = make_linkage(square_strip({1}));
  EXPECT_THROW(thickened(two, -1), InvalidOption);
  EXPECT_THROW(thickened(two, 0.1, {0.06}), InvalidOption);
  EXPECT_THROW(thickened(two, 0.1, {0.01, 0.01}), InvalidOption);
}

// 500 random chains, in five tests that run beside each other.
class ThickChains : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ThickPanelLaw, ThickChains, testing::Values(0, 100, 200, 300, 400));

TEST_P(ThickChains, TheProofAndTheCheckAgreeWithTenThousandSamplesOfBoxes) {
  int free = 0, collided = 0;
  for (int seed = GetParam() + 1; seed <= GetParam() + num_cases(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double thickness = rng.uniform(0.02, 0.4);
    std::vector<double> angles, offset;
    const double most = seed % 2 ? kPi : kPi / 2;
    for (int h = 1 + rng.below(11); h > 0; --h) {
      const double angle = rng.uniform(-most, most);
      angles.push_back(angle);
      // Mostly where the hinge can turn at all, now and then in the mid-plane or on the wrong side.
      const double side = rng.uniform() < 0.03 ? -1 : rng.uniform() < 0.03 ? 0 : 1;
      offset.push_back(side * (angle > 0 ? thickness : -thickness) / 2);
    }
    const Linkage linkage = chain(angles, offset, thickness);
    const FoldingPath path = straight(linkage);
    const PathProof proof = prove_path(linkage, path);
    const auto seen = first_collision(linkage, path, proof.clearance, proof.touch, 10000);
    ASSERT_NE(proof.verdict, PathVerdict::Undecided);
    EXPECT_FALSE(seen && proof.verdict == PathVerdict::Free) << "seen at " << *seen;
    if (proof.verdict == PathVerdict::Collides) {
      EXPECT_GT(deepest(linkage, path.at(proof.to), proof.clearance), 0);
    }
    CollisionChecker checker(linkage);
    for (int i = 0; i <= 100; ++i) {
      const double depth = deepest(linkage, path.at(i / 100.0), proof.clearance);
      if (std::abs(depth - checker.touch()) < 1e-9) continue;  // a tie is nobody's mistake
      EXPECT_EQ(checker.collides(path.at(i / 100.0)), depth > checker.touch()) << i;
    }
    (proof.verdict == PathVerdict::Free ? free : collided)++;
  }
  EXPECT_GT(free, kSanitized ? 0 : 10);
  EXPECT_GT(collided, kSanitized ? 0 : 10);
}

}  // namespace
}  // namespace plico
