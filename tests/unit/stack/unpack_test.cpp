#include "plico/stack/unpack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/stack/chain.h"
#include "plico/stack/chain_linkage.h"
#include "plico/stack/hamiltonian_cycle.h"
#include "voxel_samples.h"

namespace plico {
namespace {

using enum StackFold;

// A closed walk around some voxels, cut open, as thick panels.
Linkage chain_around(const std::vector<Voxel>& solid, double thickness, int start = 0) {
  const VoxelShell shell = shell_of(voxels(solid));
  const CycleResult cycle = find_hamiltonian_cycle(shell);
  const Chain chain = chain_of(shell, cycle.cycle, start);
  return chain_linkage(chain.headings, chain.angles, {1, thickness, thickness});
}

const std::vector<Voxel> kBar = {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}};

TEST(PileSign, IsThatOfTheFirstHingeWhenFoldsAlternate) {
  EXPECT_EQ(pile_sign({Valley, Mountain, Valley}), 1);
  EXPECT_EQ(pile_sign({Mountain, Valley}), -1);
  EXPECT_EQ(pile_sign({Valley, Flat, Valley, Mountain}), 1);  // the flat hinge becomes a mountain
  EXPECT_EQ(pile_sign({Valley, Flat, Mountain}), 0);
  EXPECT_EQ(pile_sign({Flat, Flat}), 1);
}

TEST(Swings, TurnTheLastPileFirst) {
  const std::vector<Configuration> states = swings({Valley, Flat, Valley, Flat, Valley});
  ASSERT_EQ(states.size(), 3u);
  EXPECT_EQ(states[0], (Configuration(5) << kPi, 0, kPi, 0, kPi).finished());
  EXPECT_EQ(states[1], (Configuration(5) << kPi, 0, kPi, -kPi, kPi).finished());
  EXPECT_EQ(states[2], (Configuration(5) << kPi, -kPi, kPi, -kPi, kPi).finished());
}

TEST(Peel, OpensAPileIntoTheShape) {
  for (const double thickness : {0.001, 0.02}) {
    const Linkage chain = chain_around(kBar, thickness);
    const Peel found = peel(chain, 1);
    ASSERT_TRUE(found.whole) << thickness;
    EXPECT_EQ(found.opened, chain.num_hinges());
    Configuration state(chain.num_hinges());
    for (int h = 0; h < chain.num_hinges(); ++h) state[h] = h % 2 ? -kPi : kPi;
    ASSERT_EQ(static_cast<int>(found.steps.size()), chain.num_hinges());
    for (int h = 0; h < chain.num_hinges(); ++h) {
      const PeelStep& step = found.steps[h];
      EXPECT_EQ(step.first, h);
      EXPECT_EQ(step.angles.front(), state.segment(h, step.angles.front().size())) << "goes on where it was left";
      EXPECT_EQ(step.angles.back()[0], chain.hinges[h].target);
      state.segment(h, step.angles.back().size()) = step.angles.back();
    }
  }
}

TEST(Peel, TheSameChainGivesTheSameSteps) {
  const Linkage chain = chain_around(kBar, 0.05);
  const Peel a = peel(chain, -1), b = peel(chain, -1);
  EXPECT_EQ(a.opened, b.opened);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.intervals, b.intervals);
}

TEST(Peel, GivesUpWhenItsPatienceEnds) {
  const Linkage chain = chain_around(kBar, 0.2);
  const Peel found = peel(chain, 1, {.nodes = 5});
  EXPECT_FALSE(found.whole);
  EXPECT_LE(found.nodes, 5);
}

TEST(Peel, SaysHowFarItGotWhenStopped) {
  std::stop_source stop;
  stop.request_stop();
  plico::Run run;
  run.stop = stop.get_token();
  const Peel found = peel(chain_around(kBar, 0.02), 1, {}, run);
  EXPECT_FALSE(found.whole);
  EXPECT_EQ(found.opened, 0);
}

TEST(Peel, RefusesOptionsOutOfRange) {
  const Linkage chain = chain_around(kBar, 0.02);
  EXPECT_THROW(peel(chain, 1, {.air = 0}), InvalidOption);
  EXPECT_THROW(peel(chain, 1, {.widest = 5}), InvalidOption);
  EXPECT_THROW(peel(chain, 1, {.step = 40}), InvalidOption);
  EXPECT_THROW(peel(chain, 1, {.nodes = -1}), InvalidOption);
  EXPECT_THROW(peel(chain, 1, {.patience = 0}), InvalidOption);
}

TEST(Unpacking, RunsFromTheStackToTheShapeInIncreasingTime) {
  const Linkage chain = chain_around(kBar, 0.02);
  std::vector<StackFold> folds;
  for (int h = 0; h < chain.num_hinges(); ++h) folds.push_back(h == 6 ? Flat : (h % 2 ? Mountain : Valley));
  const FoldingPath path = unpacking(chain, folds, peel(chain, pile_sign(folds)));
  EXPECT_EQ(path.waypoints.front().time, 0);
  EXPECT_EQ(path.waypoints.back().time, 1);
  EXPECT_EQ(path.waypoints.front().config[6], 0);
  EXPECT_EQ(path.waypoints.back().config, goal(chain));
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) EXPECT_LT(path.waypoints[i - 1].time, path.waypoints[i].time);
}

}  // namespace
}  // namespace plico
