#include "plico/stack/chain_linkage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

const Headings kTwo{Heading::East};

// The free length of the strip between the plates of two panels that meet at an angle: eq. 6.1. The plates end half a
// thickness before the crease.
double hinge_length(double t, double angle) {
  const Linkage chain = chain_linkage(kTwo, {angle}, {1, t, t});
  const Pose pose = folding_map(chain, goal(chain))[1];
  return (pose * Vec3(0.5 + t / 2, 0, 0) - Vec3(0.5 - t / 2, 0, 0)).norm();
}

TEST(ThickHinge, HasTheFreeLengthOfTheCorrectedEquation) {
  for (double t : {0.01, 0.1, 0.45})
    for (int degree = -180; degree <= 180; ++degree) {
      const double a = std::abs(radians(degree));
      EXPECT_NEAR(hinge_length(t, radians(degree)), t * (a <= kPi / 2 ? std::cos(a / 2) : std::sin(a / 2)), 1e-12);
    }
  EXPECT_NEAR(hinge_length(0.2, 0), 0.2, 1e-12);
  EXPECT_NEAR(hinge_length(0.2, kPi / 2), 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(hinge_length(0.2, kPi), 0.2, 1e-12);
}

TEST(ThickHinge, MatesAreFreeAtEveryAngle) {
  for (double t : {0.01, 0.1, 0.2, 0.45})
    for (double trim : {t, t / 2}) {
      const Linkage chain = chain_linkage(kTwo, {kPi}, {1, t, trim});
      for (int i = 0; i <= 3600; ++i) {
        const Pose pose = folding_map(chain, Configuration::Constant(1, radians(-180 + 0.1 * i)))[1];
        // By the section across the hinge: one of the two panels keeps to its side of a side plane of the other.
        double behind = 1e9, above = 1e9, below = -1e9;
        for (const Vec3& corner : chain.panels[1])
          for (double z : {-t / 2, t / 2}) {
            const Vec3 p = pose * Vec3(corner + Vec3(0, 0, z));
            behind = std::min(behind, p.x());
            above = std::min(above, p.z());
            below = std::max(below, p.z());
          }
        EXPECT_TRUE(behind >= 0.5 - trim - 1e-12 || above >= t / 2 - 1e-12 || below <= -t / 2 + 1e-12)
            << t << " " << trim << " " << i;
      }
    }
}

// Where thick panels are when they are folded, against the rule of the lattice.
TEST(ThickHinge, FoldsPanelsIntoTheSlotsOfTheLattice) {
  Rng rng(4);
  for (int trial = 0; trial < 200; ++trial) {
    Headings headings{Heading::East};
    std::vector<StackFold> folds;
    for (int i = 0; i < 9; ++i) {
      if (i > 0) headings.push_back(turned(headings.back(), rng.below(3) - 1));
      folds.push_back(static_cast<StackFold>(rng.below(3) - 1));
    }
    const double t = rng.uniform(0.01, 0.45);
    const Linkage chain = chain_linkage(headings, fold_angles(folds), {1, t, t});
    const std::vector<Pose> poses = folding_map(chain, goal(chain));
    const std::vector<Slot> slots = stack_slots(headings, folds);
    for (int p = 0; p < chain.num_panels(); ++p) {
      const Vec3 flat = (chain.panels[p][0] + chain.panels[p][2]) / 2;
      EXPECT_LT((poses[p] * flat - Vec3(slots[p].x, slots[p].y, t * slots[p].layer)).norm(), 1e-9);
    }
  }
}

TEST(ThickHinge, APileUnfoldsIntoAStripWithProof) {
  const Headings strip(4, Heading::East);
  const Linkage chain = chain_linkage(strip, {kPi, -kPi, kPi, -kPi}, {1, 0.1, 0.1});
  const PathProof proof = prove_path(chain, linear_path(chain), {.clearance = 0.001});
  EXPECT_EQ(proof.verdict, PathVerdict::Free);
}

// The proof's bound on how far corners stray from their chords, at chains that cross 90 degrees.
TEST(ThickHinge, NoPointStraysFartherThanTheProofSays) {
  Rng rng(8);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 2 + rng.below(5);
    const Headings strip(n - 1, Heading::East);
    const Linkage chain = chain_linkage(strip, std::vector<double>(n - 1, 0), {1, 0.3, 0.3});
    FoldingPath path{{{0, flat(chain)}, {1, flat(chain)}}};
    for (Waypoint& w : path.waypoints)
      for (int h = 0; h + 1 < n; ++h) w.config[h] = rng.uniform(-kPi, kPi);
    LinkageMotion motion(chain, path);
    const double a = rng.uniform(), b = rng.uniform(a, 1);
    std::vector<Pose> begin(n), end(n), at(n);
    motion.place(a, {}, begin);
    motion.place(b, {}, end);
    motion.look_at(a, b, begin);
    const double bend = motion.bend(n - 1, -1);
    for (int i = 1; i < 40; ++i) {
      motion.place(a + (b - a) * i / 40, {}, at);
      for (const Vec3& corner : chain.panels[n - 1]) {
        const Vec3 chord = (1 - i / 40.0) * (begin[n - 1] * corner) + i / 40.0 * (end[n - 1] * corner);
        EXPECT_LE((at[n - 1] * corner - chord).norm(), bend + 1e-12) << trial;
      }
    }
  }
}

TEST(ThickHinge, RefusesPanelsThickerThanHalfAVoxel) {
  EXPECT_THROW(chain_linkage(kTwo, {0}, {1, 0.5, 0.5}), InvalidOption);
  EXPECT_THROW(chain_linkage(kTwo, {0}, {1, 0, 0}), InvalidOption);
  EXPECT_THROW(chain_linkage(kTwo, {0}, {1, 0.2, 0.05}), InvalidOption);
}

}  // namespace
}  // namespace plico
