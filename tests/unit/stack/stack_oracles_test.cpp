// What exhaustion says about small chains, against the rule of the lattice and against thick boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "effort.h"
#include "plico/base/rng.h"
#include "plico/stack/chain.h"
#include "plico/stack/chain_linkage.h"
#include "voxel_samples.h"

namespace plico {
namespace {

Headings mirrored(Headings strip) {
  for (Heading& h : strip)
    if (!along_x(h)) h = opposite(h);
  return strip;
}

// The strips of all Hamiltonian paths, each once up to a mirror, as least_layers() does not tell the two apart.
std::set<Headings> all_strips(const VoxelShell& shell) {
  std::set<Headings> strips;
  std::vector<int> path;
  const std::function<void(int)> go = [&](int at) {
    path.push_back(at);
    if (static_cast<int>(path.size()) == shell.size()) {
      const Headings strip = chain_of(shell, path).headings;
      strips.insert(std::min(strip, mirrored(strip)));
    }
    for (int next : shell.squares[at].neighbor)
      if (std::find(path.begin(), path.end(), next) == path.end()) go(next);
    path.pop_back();
  };
  for (int s = 0; s < shell.size(); ++s) go(s);
  return strips;
}

int least_of_all(const std::set<Headings>& strips, int width, int depth) {
  int least = static_cast<int>(strips.begin()->size()) + 1;
  for (const Headings& strip : strips) least = std::min(least, least_layers(strip, width, depth, least - 1));
  return least;
}

struct Base {
  int width, depth, layers;
};

TEST(StackOracles, TheCubeNeedsTheLayersThatExhaustionFound) {
  const std::set<Headings> strips = all_strips(shell_of(voxels({{0, 0, 0}})));
  EXPECT_EQ(strips.size(), 5u);
  for (const Base& b : {Base{1, 1, 6},
                        {1, 2, 3},
                        {1, 3, 2},
                        {1, 4, 2},
                        {2, 2, 2},
                        {2, 3, 2},
                        {2, 4, 2},
                        {2, 5, 1},
                        {3, 3, 2},
                        {3, 4, 1}})
    EXPECT_EQ(least_of_all(strips, b.width, b.depth), b.layers) << b.width << "x" << b.depth;
}

TEST(StackOracles, TheDominoNeedsTheLayersThatExhaustionFound) {
  const std::set<Headings> strips = all_strips(shell_of(voxels({{0, 0, 0}, {1, 0, 0}})));
  EXPECT_EQ(strips.size(), 152u);
  for (const Base& b : {Base{1, 1, 10},
                        {1, 2, 5},
                        {1, 3, 4},
                        {1, 4, 3},
                        {1, 5, 2},
                        {2, 2, 3},
                        {2, 3, 2},
                        {2, 4, 2},
                        {2, 5, 2},
                        {2, 8, 1},
                        {3, 3, 2},
                        {3, 4, 2},
                        {3, 6, 1},
                        {4, 4, 1}})
    EXPECT_EQ(least_of_all(strips, b.width, b.depth), b.layers) << b.width << "x" << b.depth;
}

// Whether some two panels of a chain that lies in its stack share a point inside: all of them are boxes along the axes.
bool boxes_overlap(const Linkage& chain, const Configuration& stack) {
  const std::vector<Pose> poses = folding_map(chain, stack);
  std::vector<Eigen::AlignedBox3d> boxes(poses.size());
  for (std::size_t p = 0; p < poses.size(); ++p)
    for (int corner : {0, 2})  // they and the two faces span it
      for (double z : {-chain.thickness / 2, chain.thickness / 2})
        boxes[p].extend(poses[p] * Vec3(chain.panels[p][corner] + Vec3(0, 0, z)));
  for (std::size_t p = 0; p < boxes.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if ((boxes[p].intersection(boxes[q]).sizes().array() > 1e-9).all()) return true;
  return false;
}

Linkage thick_strip(const Headings& strip, double thickness) {
  return chain_linkage(strip, std::vector<double>(strip.size(), 0), {1, thickness, thickness});
}

void expect_rule_holds(const Headings& strip, const Linkage& chain, const std::vector<StackFold>& folds) {
  const std::vector<double> angles = fold_angles(folds);
  const Configuration stack = Eigen::Map<const Configuration>(angles.data(), static_cast<Eigen::Index>(angles.size()));
  EXPECT_EQ(all_distinct(stack_slots(strip, folds)), !boxes_overlap(chain, stack));
}

// The digits of `code` in base three, each one less: -1, 0, 1.
std::vector<int> signs(long code, int count) {
  std::vector<int> digits;
  for (int i = 0; i < count; ++i, code /= 3) digits.push_back(static_cast<int>(code % 3) - 1);
  return digits;
}

Headings strip_of(const std::vector<int>& turns) {
  Headings strip{Heading::East};
  for (int turn : turns) strip.push_back(turned(strip.back(), turn));
  return strip;
}

std::vector<StackFold> folds_of(const std::vector<int>& signs) {
  std::vector<StackFold> folds;
  for (int sign : signs) folds.push_back(static_cast<StackFold>(sign));
  return folds;
}

// Every turn and every fold. Left out are mirror images, whose first turn is to the right, and stacks whose last panel
// cannot matter, as those before it share a slot already.
TEST(StackOracles, TheRuleOfTheLatticeAgreesWithThickBoxesOnAllChainsOfUpToSevenPanels) {
  for (int n = 3, chains = 3, stacks = 9; n <= (kSanitized ? 6 : 7); ++n, chains *= 3, stacks *= 3)
    for (int c = 0; c < chains; ++c) {
      const std::vector<int> turns = signs(c, n - 2);
      const auto first = std::find_if(turns.begin(), turns.end(), [](int turn) { return turn != 0; });
      if (first != turns.end() && *first < 0) continue;
      const Headings strip = strip_of(turns), shorter(strip.begin(), strip.end() - 1);
      const Linkage thin = thick_strip(strip, 0.02), thick = thick_strip(strip, 0.4);
      for (int s = 0; s < stacks; ++s) {
        const std::vector<StackFold> folds = folds_of(signs(s, n - 1));
        if (all_distinct(stack_slots(shorter, {folds.begin(), folds.end() - 1})))
          expect_rule_holds(strip, s % 2 == 0 ? thin : thick, folds);
      }
    }
}

TEST(StackOracles, TheRuleOfTheLatticeAgreesWithThickBoxesOnLongerChains) {
  Rng rng(9);
  const auto random_signs = [&](int count) {
    std::vector<int> signs(count);
    for (int& sign : signs) sign = rng.below(3) - 1;
    return signs;
  };
  for (int trial = 0; trial < 600; ++trial) {
    const int n = 6 + rng.below(5);
    const Headings strip = strip_of(random_signs(n - 2));
    expect_rule_holds(strip, thick_strip(strip, rng.uniform(0.01, 0.45)), folds_of(random_signs(n - 1)));
  }
}

}  // namespace
}  // namespace plico
