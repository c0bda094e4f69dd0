#include "plico/stack/compact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/base/error.h"
#include "torus_squares.h"

namespace plico {
namespace {

bool is_path(const SquareGraph& graph, std::vector<int> path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    if (graph.side_to(path[i - 1], path[i]) < 0) return false;
  std::sort(path.begin(), path.end());
  return std::adjacent_find(path.begin(), path.end()) == path.end() && static_cast<int>(path.size()) == graph.size();
}

TEST(PathExchange, KeepsOnePathThroughAllSquaresAndItsBeginning) {
  const SquareGraph graph = torus_squares(9, 8);
  PathExchange exchange(graph, torus_cycle(9, 8));
  Rng rng(3);
  int changed = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::vector<int> before = exchange.path();
    const int fixed = rng.below(60), start = fixed + rng.below(72 - fixed);
    const int first = exchange.exchange(start, fixed, 8, rng);
    const std::vector<int>& after = exchange.path();
    if (first < 0) {
      ASSERT_EQ(after, before);
      continue;
    }
    ++changed;
    ASSERT_TRUE(is_path(graph, after)) << i;
    ASSERT_GT(first, fixed);
    ASSERT_TRUE(std::equal(before.begin(), before.begin() + first, after.begin())) << i;
    ASSERT_NE(before[first], after[first]);
    if (i % 3 == 0) {
      exchange.undo();
      ASSERT_EQ(exchange.path(), before);
    }
  }
  EXPECT_GT(changed, 50);
}

void expect_stack(const SquareGraph& graph, const Stack& stack, int width, int depth) {
  EXPECT_TRUE(is_path(graph, stack.path));
  EXPECT_EQ(stack.headings, strip_headings(graph, stack.path));
  const std::vector<Slot> slots = stack_slots(stack.headings, stack.folds);
  EXPECT_TRUE(all_distinct(slots));
  EXPECT_EQ(box_of(slots), stack.box);
  EXPECT_LE(stack.box.width, width);
  EXPECT_LE(stack.box.depth, depth);
}

TEST(CompactStack, FillsBlocksToTheIdealLayers) {
  const SquareGraph graph = torus_squares(12, 20);
  for (const auto& [width, depth] : {std::pair{1, 1}, {1, 2}, {2, 2}, {3, 3}, {4, 4}, {3, 5}}) {
    const CompactResult result =
        compact_stack(graph, torus_cycle(12, 20), true, {.seed = 1, .width = width, .depth = depth});
    expect_stack(graph, result.best, width, depth);
    EXPECT_EQ(result.ending, Ending::Found) << width << "x" << depth;
    EXPECT_EQ(result.best.box.height, ideal_layers(240, width, depth)) << width << "x" << depth;
  }
}

// More empty slots than a pile has layers: all of them may be left in the first piles.
TEST(CompactStack, ReachesTheIdealWhereTheBlockHasRoomToSpare) {
  const SquareGraph graph = torus_squares(20, 20);
  for (std::uint64_t seed : {1, 2}) {
    const CompactResult result =
        compact_stack(graph, torus_cycle(20, 20), true, {.seed = seed, .width = 7, .depth = 7, .exchanges = 2'000'000});
    expect_stack(graph, result.best, 7, 7);
    EXPECT_EQ(result.best.box.height, 9) << seed;
  }
}

TEST(CompactStack, TheSameSeedGivesTheSameStack) {
  const SquareGraph graph = torus_squares(10, 10);
  const CompactOptions options{.seed = 5, .width = 4, .depth = 4};
  const CompactResult a = compact_stack(graph, torus_cycle(10, 10), true, options);
  const CompactResult b = compact_stack(graph, torus_cycle(10, 10), true, options);
  EXPECT_EQ(a.best.path, b.best.path);
  EXPECT_EQ(a.best.folds, b.best.folds);
}

TEST(CompactStack, IsAStackEvenWhenThereIsNoTime) {
  const SquareGraph graph = torus_squares(12, 12);
  plico::Run run;
  run.deadline = plico::Run::Clock::now();
  const CompactResult result =
      compact_stack(graph, torus_cycle(12, 12), true, {.seed = 1, .width = 5, .depth = 5}, run);
  expect_stack(graph, result.best, 5, 5);
  EXPECT_TRUE(result.ending == Ending::TimedOut || result.ending == Ending::Found);
}

TEST(CompactStack, RefusesABaseLargerThanTheChain) {
  const SquareGraph graph = torus_squares(4, 4);
  EXPECT_THROW(compact_stack(graph, torus_cycle(4, 4), true, {.width = 5, .depth = 5}), InvalidOption);
}

TEST(CompactStack, TheBestBaseIsThatOfTheStudy) {
  EXPECT_EQ(best_base(2206, 0.0001), (StackBox{1, 1, 2206}));
  EXPECT_EQ(best_base(2206, 0.001), (StackBox{1, 2, 1103}));
  EXPECT_EQ(best_base(2206, 0.01), (StackBox{3, 3, 246}));
  EXPECT_EQ(best_base(2206, 0.1), (StackBox{6, 6, 62}));
  EXPECT_EQ(best_base(2206, 0.2), (StackBox{8, 8, 35}));
}

TEST(CompactStack, TheBestBaseInABlockFitsIntoItEitherWayRound) {
  for (const StackBox& room : {StackBox{8, 3, 100}, StackBox{3, 8, 100}}) {
    const std::optional<StackBox> base = best_base_in(room, 2206, 0.2);
    ASSERT_TRUE(base);
    EXPECT_EQ(*base, (StackBox{3, 8, 92}));
  }
  EXPECT_EQ(best_base_in({20, 20, 30}, 2206, 0.2), (StackBox{9, 9, 28}));
  EXPECT_FALSE(best_base_in({8, 3, 91}, 2206, 0.2));
}

}  // namespace
}  // namespace plico
