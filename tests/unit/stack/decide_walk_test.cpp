#include "plico/stack/decide_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "plico/base/rng.h"
#include "plico/verify/shell_cycle.h"
#include "torus_squares.h"
#include "voxel_samples.h"

namespace plico {
namespace {

SquareGraph squares_of(const VoxelShell& shell) {
  SquareGraph graph;
  for (const ShellSquare& square : shell.squares) graph.neighbours.push_back(square.neighbor);
  return graph;
}

// Three cubes around a fourth, over an edge each: squares of the same empty voxel are joined there.
VoxelGrid star_of_cubes() { return voxels({{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {2, 0, 1}}); }

bool has_cycle(const SquareGraph& graph) {
  std::vector<char> seen(graph.size(), 0);
  const std::function<bool(int, int)> go = [&](int at, int visited) {
    if (visited == graph.size()) return graph.side_to(at, 0) >= 0;
    for (int next : graph.neighbours[at]) {
      if (seen[next]) continue;
      seen[next] = 1;
      if (go(next, visited + 1)) return true;
      seen[next] = 0;
    }
    return false;
  };
  seen[0] = 1;
  return go(0, 1);
}

TEST(DecideWalk, FindsWalksThatTheJudgeAccepts) {
  const VoxelGrid grid = voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}});
  const VoxelShell shell = shell_of(grid);
  const WalkDecision cycle = decide_walk(squares_of(shell), Walk::Cycle);
  EXPECT_EQ(cycle.ending, Ending::Found);
  EXPECT_TRUE(verify_shell_cycle(grid, Pairing::Solid, in_order(shell, cycle.squares)).valid());
  const WalkDecision path = decide_walk(squares_of(shell), Walk::Path);
  EXPECT_EQ(path.ending, Ending::Found);
  EXPECT_TRUE(verify_shell_path(grid, Pairing::Solid, in_order(shell, path.squares)).valid());
}

TEST(DecideWalk, ProvesThatAStarOfCubesHasAPathButNoCycle) {
  const VoxelGrid grid = star_of_cubes();
  const VoxelShell shell = shell_of(grid, Pairing::Empty);
  const SquareGraph graph = squares_of(shell);
  ASSERT_FALSE(has_cycle(graph));
  EXPECT_EQ(decide_walk(graph, Walk::Cycle).ending, Ending::Exhausted);
  const WalkDecision path = decide_walk(graph, Walk::Path);
  ASSERT_EQ(path.ending, Ending::Found);
  const std::vector<ShellSquare> walk = in_order(shell, path.squares);
  EXPECT_TRUE(verify_shell_path(grid, Pairing::Empty, walk).valid());
  EXPECT_FALSE(verify_shell_cycle(grid, Pairing::Empty, walk).valid());
}

TEST(DecideWalk, AgreesWithExhaustionOnRandomShells) {
  int without = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Voxel> cubes;
    for (int i = 0; i < 4; ++i) {
      const int x = rng.below(3), z = rng.below(3);
      cubes.push_back({x, 0, z});
    }
    for (const VoxelShell& piece : pieces_of(shell_of(voxels(cubes), Pairing::Empty))) {
      const SquareGraph graph = squares_of(piece);
      const bool found = decide_walk(graph, Walk::Cycle).ending == Ending::Found;
      ASSERT_EQ(found, has_cycle(graph));
      without += !found;
    }
  }
  EXPECT_GT(without, 0);
}

TEST(DecideWalk, SquaresInTwoPiecesHaveNoWalk) {
  const SquareGraph graph = squares_of(shell_of(voxels({{0, 0, 0}, {3, 0, 0}})));
  EXPECT_EQ(decide_walk(graph, Walk::Cycle).ending, Ending::Exhausted);
  EXPECT_EQ(decide_walk(graph, Walk::Path).ending, Ending::Exhausted);
}

TEST(DecideWalk, SaysNothingWhenItsTimeIsUp) {
  plico::Run run;
  run.deadline = plico::Run::Clock::now();
  const WalkDecision decision = decide_walk(torus_squares(6, 6), Walk::Cycle, run);
  EXPECT_EQ(decision.ending, Ending::TimedOut);
  EXPECT_TRUE(decision.squares.empty());
}

}  // namespace
}  // namespace plico
