// What changes when a branch is hung elsewhere equals what is counted afresh.
#include <gtest/gtest.h>

#include "mesh_samples.h"
#include "plico/unfold/handy_folds.h"
#include "plico/unfold/heuristics.h"
#include "random_hanging.h"

namespace plico {
namespace {

// Stretched, so that many faces are needles.
Mesh stretched_sphere(int seed) {
  PolygonSoup soup = bumpy_sphere(2, 0.2, seed).soup();
  for (Vec3& p : soup.points) p.x() *= 6;
  return Mesh(soup);
}

TEST(HandyFoldsLaw, TheChangeOfAHangingIsTheDifferenceOfTheCounts) {
  for (int seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = stretched_sphere(seed);
    const FlatFaces faces(mesh);
    Rng rng(seed);
    DualTree tree(faces, lightest_forest(mesh, dual_weights(mesh, Heuristic::Random, Vec3::UnitX(), rng)));
    const HandyFolds handy(tree, 0.6);
    EXPECT_GT(handy.all().weak_folds, 0);
    EXPECT_GT(handy.all().needles, 0);
    for (int move = 0; move < 60; ++move) {
      const int side = random_hanging(tree, mesh, rng);
      if (side < 0) continue;
      const HandFaults before = handy.all(), change = handy.change_if_hung(side);
      tree.hang(side);
      EXPECT_NEAR(handy.all().weak_folds, before.weak_folds + change.weak_folds, 1e-9);
      EXPECT_EQ(handy.all().needles, before.needles + change.needles);
      if (move % 10 == 5) tree.balance();
    }
  }
}

}  // namespace
}  // namespace plico
