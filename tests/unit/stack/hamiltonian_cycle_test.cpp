#include "plico/stack/hamiltonian_cycle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/named_shapes.h"
#include "plico/stack/chain.h"
#include "plico/stack/voxelize.h"
#include "plico/verify/shell_cycle.h"
#include "voxel_samples.h"

namespace plico {
namespace {

// Undirected Hamiltonian cycles and directed Hamiltonian paths, by looking at all walks.
struct Count {
  long cycles = 0, paths = 0;
  bool operator==(const Count&) const = default;
};

// Walks begin at the first `starts` squares; every cycle passes through the first.
Count count_all(const VoxelShell& shell, int starts) {
  Count count;
  std::vector<char> seen(shell.size(), 0);
  int start = 0;
  const std::function<void(int, int)> go = [&](int at, int visited) {
    if (visited == shell.size()) {
      ++count.paths;
      if (start == 0)
        for (int next : shell.squares[at].neighbor) count.cycles += next == 0;
      return;
    }
    for (int next : shell.squares[at].neighbor) {
      if (seen[next]) continue;
      seen[next] = 1;
      go(next, visited + 1);
      seen[next] = 0;
    }
  };
  for (start = 0; start < starts; ++start) {
    seen[start] = 1;
    go(start, 1);
    seen[start] = 0;
  }
  count.cycles /= 2;
  return count;
}

Count count_all(const VoxelShell& shell) { return count_all(shell, shell.size()); }

TEST(VoxelShell, SmallSolidsHaveTheCyclesAndPathsThatExhaustionFound) {
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}}))), (Count{16, 240}));
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}, {1, 0, 0}}))), (Count{52, 2432}));
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}))), (Count{180, 17792}));
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))), (Count{168, 17108}));
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}))), (Count{396, 51632}));
  EXPECT_EQ(count_all(shell_of(voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}))), (Count{644, 111728}));
}

TEST(VoxelShell, TheCubeOfEightHasTheCyclesThatExhaustionFound) {
  VoxelGrid grid(2, 2, 2);
  for (int i = 0; i < 8; ++i) grid.fill({i & 1, i >> 1 & 1, i >> 2});
  EXPECT_EQ(count_all(shell_of(grid), 1).cycles, 6020);
}

TEST(VoxelShell, ItsSurfaceIsAClosedManifoldWithEitherPairing) {
  const VoxelGrid grid = voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  for (Pairing pairing : {Pairing::Solid, Pairing::Empty}) {
    const Mesh mesh(surface_of(shell_of(grid, pairing), {1, 2, 3}, 0.5));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume(mesh), 6 * 0.125, 1e-12);
  }
}

TEST(HamiltonianCycle, EverySeedFindsOneThatTheJudgeAccepts) {
  for (const char* name : {"dinosaur", "torus", "bird"}) {
    const Voxelization solid = voxelize(make_shape(name), 16);
    const VoxelShell shell = shell_of(solid.grid);
    if (pieces_of(shell).size() > 1) continue;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const CycleResult found = find_hamiltonian_cycle(shell, {.seed = seed});
      ASSERT_EQ(found.ending, Ending::Found) << name << seed;
      const CycleVerdict verdict = verify_shell_cycle(solid.grid, Pairing::Solid, in_order(shell, found.cycle));
      EXPECT_TRUE(verdict.valid()) << name << seed << ": " << verdict.problems.front();
    }
  }
}

TEST(HamiltonianCycle, TheJudgeFindsASquareLeftOutVisitedTwiceOrReachedAcrossAGap) {
  const VoxelGrid grid = voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  const VoxelShell shell = shell_of(grid);
  const std::vector<int> cycle = find_hamiltonian_cycle(shell).cycle;
  std::vector<int> short_of_one(cycle.begin(), cycle.end() - 1), twice = cycle, swapped = cycle;
  twice.push_back(cycle.front());
  std::swap(swapped[1], swapped[6]);
  for (const std::vector<int>& wrong : {short_of_one, twice, swapped})
    EXPECT_FALSE(verify_shell_cycle(grid, Pairing::Solid, in_order(shell, wrong)).valid());
}

TEST(HamiltonianCycle, WhereFourSquaresMeetThePairingDecides) {
  const VoxelGrid grid = voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  for (Pairing pairing : {Pairing::Solid, Pairing::Empty}) {
    const VoxelShell shell = shell_of(grid, pairing);
    EXPECT_EQ(shell.edges_with_four, 1);
    const CycleResult found = find_hamiltonian_cycle(shell);
    ASSERT_EQ(found.ending, Ending::Found);
    EXPECT_TRUE(verify_shell_cycle(grid, pairing, in_order(shell, found.cycle)).valid());
  }
}

// Voxels grown one beside another, so that the shell is often in one piece with edges of four squares.
VoxelGrid random_solid(Rng rng, int count) {
  std::vector<Voxel> grown{{4, 4, 4}};
  while (static_cast<int>(grown.size()) < count) {
    const Voxel& from = grown[rng.below(static_cast<int>(grown.size()))];
    const Voxel next = beside(from, static_cast<Axis>(rng.below(6)));
    if (std::min({next.x, next.y, next.z}) >= 0 && std::max({next.x, next.y, next.z}) < 8) grown.push_back(next);
  }
  return voxels(grown);
}

TEST(HamiltonianCycle, VoxelsCutIntoEightHaveOneThatIsFoundWithoutATry) {
  for (int i = 0; i < 40; ++i) {
    const VoxelGrid fine = refined(random_solid(Rng(1).stream(i), 3 + 2 * i), 2);
    const Pairing pairing = i % 2 ? Pairing::Solid : Pairing::Empty;
    const VoxelShell shell = shell_of(fine, pairing);
    if (pieces_of(shell).size() > 1) continue;
    const CycleResult found = find_hamiltonian_cycle(shell);
    ASSERT_EQ(found.ending, Ending::Found) << i;
    EXPECT_EQ(found.tries, 0) << i;
    EXPECT_TRUE(verify_shell_cycle(fine, pairing, in_order(shell, found.cycle)).valid()) << i;
  }
}

TEST(HamiltonianCycle, NoShellAndSeveralShellsAreRefused) {
  EXPECT_THROW(find_hamiltonian_cycle({}), InvalidInput);
  EXPECT_THROW(find_hamiltonian_cycle(shell_of(voxels({{0, 0, 0}, {3, 0, 0}}))), InvalidInput);
}

TEST(Chain, FoldingTheUnrolledStripGivesTheVoxelsBack) {
  const VoxelShell shell = shell_of(voxelize(make_shape("bird"), 12).grid);
  ASSERT_EQ(pieces_of(shell).size(), 1u);
  const std::vector<int> cycle = find_hamiltonian_cycle(shell).cycle;
  for (int start : {0, 7, 100}) {
    const Chain chain = chain_of(shell, cycle, start, start == 7);
    // Frames of flat squares are turned about their common edge by the fold angle, one after the other.
    Vec3 centre = middle_of(shell.squares[chain.squares[0]]), front = front_of(shell.squares[chain.squares[0]]);
    Vec3 east = middle_of(shell.squares[chain.squares[1]]) - centre;
    east = (east - east.dot(front) * front).normalized();
    Vec3 north = front.cross(east);
    for (std::size_t i = 0; i < chain.headings.size(); ++i) {
      const double sign = index(chain.headings[i]) < 2 ? 1 : -1;
      const Vec3 ahead = sign * (along_x(chain.headings[i]) ? east : north);
      const Vec3 axis = ahead.cross(front);  // turning up about it is a valley seen from the front
      const Pose turn = rotation_about(centre + ahead / 2, -axis, -chain.angles[i]);
      centre = turn * Vec3(centre + ahead);
      front = turn.linear() * front;
      east = turn.linear() * east;
      north = turn.linear() * north;
      const ShellSquare& square = shell.squares[chain.squares[i + 1]];
      ASSERT_LT((centre - middle_of(square)).norm(), 1e-9) << i;
      ASSERT_LT((front - front_of(square)).norm(), 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace plico
