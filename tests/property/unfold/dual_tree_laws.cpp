// Whatever is hung where, the state kept up to date equals the one laid out afresh.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_samples.h"
#include "plico/unfold/dual_tree.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/overlap.h"
#include "random_hanging.h"

namespace plico {
namespace {

std::vector<std::pair<int, int>> pairs_of(const DualTree& tree) {
  std::vector<std::pair<int, int>> pairs;
  for (int a : tree.overlapping_panels())
    for (int b : tree.overlapping(a))
      if (a < b) pairs.emplace_back(a, b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void expect_consistent(const DualTree& tree) {
  const int n = tree.mesh().num_faces();
  std::vector<int> size(n, 1);
  std::vector<int> order(n);
  for (int f = 0; f < n; ++f) order[f] = f;
  std::sort(order.begin(), order.end(), [&](int a, int b) { return tree.depth(a) > tree.depth(b); });
  for (int f : order) {
    EXPECT_EQ(tree.subtree_size(f), size[f]);
    if (tree.parent(f) < 0) continue;
    EXPECT_EQ(tree.depth(f), tree.depth(tree.parent(f)) + 1);
    size[tree.parent(f)] += size[f];
  }
}

TEST(DualTreeLaw, HangingKeepsOverlapsDepthsAndSizesTrue) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = bumpy_sphere(2, 0.2, seed);
    const FlatFaces faces(mesh);
    Rng rng(seed);
    DualTree tree(faces, lightest_forest(mesh, dual_weights(mesh, Heuristic::Random, Vec3::UnitX(), rng)));
    for (int move = 0; move < 30; ++move) {
      const int side = random_hanging(tree, mesh, rng);
      if (side < 0) continue;
      long looked = 0;
      const int expected =
          tree.num_overlaps() - tree.overlaps_with_rest() + tree.overlaps_if_hung(side, 1 << 30, looked);
      tree.hang(side);
      EXPECT_EQ(tree.num_overlaps(), expected);
      if (move % 10 == 5) tree.balance();
    }
    expect_consistent(tree);
    auto afresh = overlapping_pairs(faces, lay_panels(faces, tree.forest()));
    std::sort(afresh.begin(), afresh.end());
    EXPECT_EQ(pairs_of(tree), afresh);
  }
}

TEST(DualTreeLaw, AnAggravatedPairCountsMore) {
  const Mesh mesh = bumpy_sphere(2, 0.3, 1);
  const FlatFaces faces(mesh);
  Rng rng(1);
  DualTree tree(faces, lightest_forest(mesh, dual_weights(mesh, Heuristic::Random, Vec3::UnitX(), rng)));
  const int a = tree.overlapping_panels()[0], b = tree.overlapping(a)[0];
  int lower = tree.depth(a) > tree.depth(b) ? a : b;
  if (tree.parent(lower) < 0) lower = lower == a ? b : a;
  tree.gather(lower);
  const int before = tree.overlaps_with_rest();
  tree.aggravate(a, b, 3);
  tree.aggravate(a, b, 4);
  EXPECT_EQ(tree.overlaps_with_rest(), before + 7);
  EXPECT_EQ(tree.num_overlaps(), static_cast<int>(pairs_of(tree).size()));
}

}  // namespace
}  // namespace plico
