#include "plico/verify/chain_segment.h"

#include <gtest/gtest.h>

#include "plico/stack/chain_linkage.h"
#include "plico/verify/chain_approach.h"

namespace plico {
namespace {

constexpr double kThickness = 0.1;

// Four panels in a row, hinges 0 and 1 turned from nearly flat to nearly closed.
struct Moving {
  Linkage chain = chain_linkage(Headings(3, Heading::East), {0, 0, 0}, {1, kThickness, kThickness});
  Configuration from = Configuration::Constant(3, 0.2), to = from;
  std::vector<Pose> start;

  Moving() {
    to[0] = 3;
    to[1] = -2.5;
    start = folding_map(chain, from);
  }
  ChainSegment segment() const { return {chain, start, from, to, 0.01}; }
};

TEST(ChainPoses, AreThoseOfTheFoldingMapAfterEveryChange) {
  const Moving moving;
  ChainPoses poses(moving.chain);
  for (double time : {0.0, 0.3, 0.9, 0.1}) {
    const Configuration config = moving.from + time * (moving.to - moving.from);
    poses.fold(config);
    const std::vector<Pose> all = folding_map(moving.chain, config);
    for (int p = 0; p < moving.chain.num_panels(); ++p) EXPECT_TRUE(poses.all()[p].isApprox(all[p], 1e-12));
  }
}

TEST(ChainSegment, AThickHingeTurnsAboutAnotherAxisBeyondARightAngle) {
  const std::vector<double> changes = Moving().segment().changes_of_axis(0, 2);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NEAR(changes[0], (kPi / 2 - 0.2) / 2.8, 1e-12);
  EXPECT_NEAR(changes[1], (kPi / 2 + 0.2) / 2.7, 1e-12);
}

TEST(ChainSegment, TurnsTellTheVelocityOfWhatMoves) {
  const Moving moving;
  const ChainSegment segment = moving.segment();
  const Vec3 point(3, 0.4, 0.2);
  for (double time : {0.1, 0.55, 0.8}) {  // before, between and after the changes of axis
    const auto turns = segment.turns(0, 2, time, time + 1e-3);
    const auto place = [&](double when) { return Vec3(segment.moved(0, 2, when) * point); };
    Vec3 velocity = Vec3::Zero();
    for (const auto& turn : turns.turns) velocity += turn.rate.cross(place(time) - turn.point);
    EXPECT_LT((velocity - (place(time + 1e-5) - place(time - 1e-5)) / 2e-5).norm(), 1e-6) << time;
  }
}

// What is told to be apart for a while is apart at every moment of it.
TEST(ChainApproach, KeepsApartForAsLongAsItSays) {
  const Moving moving;
  const ChainSegment segment = moving.segment();
  const OrientedBox& resting = segment.blocks().front().box;
  for (const ChainBlock& block : segment.blocks()) {
    if (block.group == 0 || segment.are_mates(segment.blocks().front(), block)) continue;
    const ChainApproach way(segment, 0, block);
    for (double time = 0; time < 1; time += 0.01) {
      const double until = gap(resting, way.at(time)) > 0 ? way.apart_until(resting, time) : time;
      for (int i = 1; i < 100; ++i)
        EXPECT_TRUE(until == time || gap(resting, way.at(time + (until - time) * i / 100)) > 0) << time;
    }
  }
}

TEST(ChainApproach, WhatSlidesAlongABoxIsApartFromItForLong) {
  // Two panels folded beside each other: the last turns about an edge of the others' plane, next to the first.
  Linkage chain = chain_linkage({Heading::East, Heading::North, Heading::West}, {0, 0, 0}, {1, kThickness, kThickness});
  const Configuration from = Configuration::Zero(3);
  Configuration to = from;
  to[2] = 1.5;
  const std::vector<Pose> start = folding_map(chain, from);
  const ChainSegment segment(chain, start, from, to, 0.01);
  const ChainApproach way(segment, 0, segment.blocks().back());
  EXPECT_EQ(way.apart_until(segment.blocks().front().box, 0), 1);
}

}  // namespace
}  // namespace plico
