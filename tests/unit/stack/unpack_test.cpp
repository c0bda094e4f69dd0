#include "plico/stack/unpack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>
#include <utility>

#include "plico/base/error.h"
#include "plico/stack/chain.h"
#include "plico/stack/chain_linkage.h"
#include "plico/stack/hamiltonian_cycle.h"
#include "plico/stack/peel_by_samples.h"
#include "plico/verify/chain_motion.h"
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

// The same hinges told the other way round, so that the left panel is the one that moves.
Linkage with_hinges_reversed(Linkage chain) {
  for (Hinge& hinge : chain.hinges) {
    std::swap(hinge.left, hinge.right);
    std::swap(hinge.from, hinge.to);
  }
  return chain;
}

struct PileOrder {
  Headings headings;
  std::vector<StackFold> folds;
};

// Piles of `height` panels over cells that follow each other side by side, in a strip made for it.
PileOrder piles_over(const std::vector<std::pair<int, int>>& cells, int height) {
  PileOrder order;
  StackWalk walk;
  const auto pass = [&](Heading heading, StackFold fold) {
    walk.pass(heading, fold);
    order.headings.push_back(heading);
    order.folds.push_back(fold);
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int k = 1; k < height; ++k) pass(Heading::East, order.folds.size() % 2 == 0 ? Valley : Mountain);
    if (i + 1 == cells.size()) break;
    const int dx = cells[i + 1].first - cells[i].first, dy = cells[i + 1].second - cells[i].second;
    const Heading step = dx > 0 ? Heading::East : dx < 0 ? Heading::West : dy > 0 ? Heading::North : Heading::South;
    pass(walk.flat_direction(step) == step ? step : opposite(step), Flat);
  }
  return order;
}

PathVerdict verdict_on_swings(const PileOrder& order) {
  const Linkage chain = chain_linkage(order.headings, std::vector<double>(order.folds.size(), 0), {1, 0.1, 0.1});
  const std::vector<Configuration> states = swings(order.folds);
  FoldingPath path;
  for (std::size_t i = 0; i < states.size(); ++i)
    path.waypoints.push_back({static_cast<double>(i) / static_cast<double>(states.size() - 1), states[i]});
  return judge_chain_motion(chain, path).verdict;
}

// A later pile swings in its own lane; an earlier one that stands there is hit.
TEST(Swings, OfASnakeAreFreeAndOfASpiralCollide) {
  std::vector<std::pair<int, int>> snake, spiral{{0, 0}};
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) snake.emplace_back(y % 2 == 0 ? x : 3 - x, y);
  for (const auto& [dx, dy, steps] :
       {std::tuple{1, 0, 3}, {0, 1, 3}, {-1, 0, 3}, {0, -1, 2}, {1, 0, 2}, {0, 1, 1}, {-1, 0, 1}})
    for (int i = 0; i < steps; ++i) spiral.emplace_back(spiral.back().first + dx, spiral.back().second + dy);
  for (const auto& cells : {snake, spiral}) {
    const PileOrder order = piles_over(cells, 4);
    const std::vector<Slot> slots = stack_slots(order.headings, order.folds);
    EXPECT_TRUE(all_distinct(slots));
    EXPECT_EQ(box_of(slots), (StackBox{4, 4, 4}));
    ASSERT_NE(pile_sign(order.folds), 0);
  }
  EXPECT_EQ(verdict_on_swings(piles_over(snake, 4)), PathVerdict::Free);
  EXPECT_EQ(verdict_on_swings(piles_over(spiral, 4)), PathVerdict::Collides);
}

TEST(Peel, DoesNotCareOnWhichSideOfItsHingesAPanelMoves) {
  const Linkage chain = chain_around(kBar, 0.05);
  const Peel found = peel(chain, 1), reversed = peel(with_hinges_reversed(chain), 1);
  EXPECT_TRUE(found.whole);
  EXPECT_TRUE(reversed.whole);
  EXPECT_EQ(found.nodes, reversed.nodes);
  EXPECT_EQ(found.intervals, reversed.intervals);
}

TEST(Peel, BySamplesLooksAtNoIntervals) {
  const Linkage chain = chain_around(kBar, 0.05);
  EXPECT_GT(peel(chain, 1).intervals, 0);
  EXPECT_EQ(peel_by_samples(chain, 1, 7.5).intervals, 0);
  EXPECT_THROW(peel_by_samples(chain, 1, 0), InvalidOption);
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

// In the thin limit no arm is needed: one hinge after the other.
TEST(Peel, OneHingeAtATimeWillDoForPanelsAsThinAsFilm) {
  const std::vector<Voxel> stairs = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}};
  for (const std::vector<Voxel>& solid : {kBar, stairs}) {
    ASSERT_EQ(shell_of(voxels(solid)).edges_with_four, 0);
    for (int start = 0; start < 12; start += 3) {
      const Peel found = peel(chain_around(solid, 1e-6, start), 1, {.widest = 1});
      EXPECT_TRUE(found.whole) << start << ": " << found.opened;
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
