#include "plico/motion/branch_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <queue>

#include "plico/base/rng.h"
#include "plico/motion/collision.h"

namespace plico {
namespace {

// A closed band of squares with a lid on some of them has many spanning trees; the shape need not close when folded.
PanelKit grid_kit(int n, Rng& rng) {
  PanelKit kit;
  for (int p = 0; p < n * n; ++p) {
    kit.outlines.push_back({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    kit.first_side.push_back(4 * (p + 1));
    for (int side = 0; side < 4; ++side) {
      kit.twin.push_back(-1);
      kit.fold_angle.push_back(0);
    }
  }
  const auto join = [&](int a, int b) {
    kit.twin[a] = b;
    kit.twin[b] = a;
    kit.fold_angle[a] = kit.fold_angle[b] = rng.uniform(-2.5, 2.5);
  };
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      if (x + 1 < n) join(4 * (y * n + x) + 1, 4 * (y * n + x + 1) + 3);
      if (y + 1 < n) join(4 * (y * n + x) + 2, 4 * ((y + 1) * n + x) + 0);
    }
  }
  return kit;
}

int panel_of(int side) { return side / 4; }

std::vector<char> random_tree(const PanelKit& kit, Rng& rng) {
  std::vector<char> joined(kit.twin.size(), 0), reached(kit.num_panels(), 0);
  reached[0] = 1;
  for (int count = 1; count < kit.num_panels();) {
    const int side = rng.below(static_cast<int>(kit.twin.size()));
    if (kit.twin[side] < 0 || !reached[panel_of(side)] || reached[panel_of(kit.twin[side])]) continue;
    joined[side] = joined[kit.twin[side]] = 1;
    reached[panel_of(kit.twin[side])] = 1;
    ++count;
  }
  return joined;
}

// The panels beyond the joined side, seen from its panel.
std::vector<int> branch_beyond(const PanelKit& kit, const std::vector<char>& joined, int side) {
  std::vector<int> branch{panel_of(kit.twin[side])};
  std::vector<char> seen(kit.num_panels(), 0);
  seen[panel_of(side)] = seen[branch[0]] = 1;
  for (std::size_t at = 0; at < branch.size(); ++at)
    for (int s = 4 * branch[at]; s < 4 * branch[at] + 4; ++s)
      if (joined[s] && !seen[panel_of(kit.twin[s])]) {
        seen[panel_of(kit.twin[s])] = 1;
        branch.push_back(panel_of(kit.twin[s]));
      }
  return branch;
}

std::vector<std::array<int, 3>> sorted(const std::vector<BranchSampler::Conflict>& conflicts) {
  std::vector<std::array<int, 3>> list;
  for (const auto& c : conflicts)
    list.push_back({c.sample, std::min(c.panel_a, c.panel_b), std::max(c.panel_a, c.panel_b)});
  std::sort(list.begin(), list.end());
  return list;
}

TEST(BranchSamplerLaw, HangingBranchesKeepsTheConflictsOfStartingAfresh) {
  int moves = 0;
  for (int seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const PanelKit kit = grid_kit(4, rng);
    std::vector<char> joined = random_tree(kit, rng);
    BranchSampler kept(kit, FoldingLaw::Linear, 1e-3, 1e-6);
    for (double t : {0.2, 0.5, 0.8, 1.0}) kept.add_sample(t);
    kept.reset(joined);
    for (int step = 0; step < 20; ++step) {
      const int cut = rng.below(static_cast<int>(joined.size()));
      if (!joined[cut]) continue;
      const std::vector<int> branch = branch_beyond(kit, joined, cut);
      const int side = 4 * branch[rng.below(static_cast<int>(branch.size()))] + rng.below(4);
      if (kit.twin[side] < 0 || std::count(branch.begin(), branch.end(), panel_of(kit.twin[side]))) continue;
      const long before = static_cast<long>(kept.conflicts().size()) - kept.conflicts_across(branch);
      const long added = kept.conflicts_if_hung(branch, side, 1000000);
      kept.hang(branch, side);
      joined[cut] = joined[kit.twin[cut]] = 0;
      joined[side] = joined[kit.twin[side]] = 1;
      EXPECT_EQ(static_cast<long>(kept.conflicts().size()), before + added);
      BranchSampler fresh(kit, FoldingLaw::Linear, 1e-3, 1e-6);
      for (double t : {0.2, 0.5, 0.8, 1.0}) fresh.add_sample(t);
      fresh.reset(joined);
      EXPECT_EQ(sorted(kept.conflicts()), sorted(fresh.conflicts()));
      ++moves;
    }
  }
  EXPECT_GT(moves, 100);
}

}  // namespace
}  // namespace plico
