#include "plico/unfold/heuristics.h"

#include <gtest/gtest.h>

#include "mesh_samples.h"
#include "plico/mesh/measures.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/classic.h"
#include "plico/unfold/grow.h"
#include "plico/unfold/overlap.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

TEST(Heuristics, GiveASpanningTreeWithWeightsInRange) {
  const Mesh mesh = bumpy_sphere(1, 0.3, 2);
  Rng rng(1);
  for (Heuristic heuristic : kHeuristics) {
    SCOPED_TRACE(name(heuristic));
    const auto weights = dual_weights(mesh, heuristic, random_direction(rng), rng);
    for (double w : weights) {
      EXPECT_GE(w, 0);
      EXPECT_LE(w, 1 + 1e-12);
    }
    EXPECT_EQ(count_parts(mesh, lightest_forest(mesh, weights)), 1);
  }
}

TEST(Heuristics, MinimumPerimeterCutsTheLeastOfAll) {
  const Mesh mesh = bumpy_sphere(1, 0.3, 2);
  Rng rng(1);
  const auto cut_length = [&](Heuristic heuristic) {
    const FoldForest forest = lightest_forest(mesh, dual_weights(mesh, heuristic, Vec3::UnitZ(), rng));
    double sum = 0;
    for (EdgeId e : mesh.edges()) sum += forest.is_fold[e] ? 0 : length(mesh, e);
    return sum;
  };
  for (Heuristic other : kHeuristics)
    EXPECT_LE(cut_length(Heuristic::MinimumPerimeter), cut_length(other) + 1e-12) << name(other);
}

TEST(Heuristics, SteepestEdgeFoldsWhatLiesAcrossTheDirection) {
  const Mesh mesh = tetrahedron_mesh();
  Rng rng(1);
  const Vec3 along = (mesh.point(VertexId(1)) - mesh.point(VertexId(0))).normalized();
  const FoldForest forest = lightest_forest(mesh, dual_weights(mesh, Heuristic::SteepestEdge, along, rng));
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const bool is_along = mesh.from(h) + mesh.to(h) == 1;  // vertices 0 and 1
    EXPECT_TRUE(!is_along || !forest.is_fold[e]);
  }
}

TEST(Overlap, AgreesWithEveryPairTriedByItself) {
  const Mesh mesh = bumpy_sphere(2, 0.3, 4);
  const FlatFaces faces(mesh);
  Rng rng(3);
  for (int trial = 0; trial < 10; ++trial) {
    const auto weights = dual_weights(mesh, Heuristic::Random, Vec3::UnitX(), rng);
    const auto at = lay_panels(faces, lightest_forest(mesh, weights));
    std::vector<std::pair<int, int>> pairs;
    for (int b = 0; b < mesh.num_faces(); ++b)
      for (int a = 0; a < b; ++a)
        if (faces.overlap(a, &at[3 * a], b, &at[3 * b])) pairs.emplace_back(a, b);
    EXPECT_EQ(overlapping_pairs(faces, at), pairs);
  }
}

TEST(Grow, LeavesFarFewerOverlapsThanTheSameWeightsAlone) {
  const Mesh mesh = bumpy_sphere(3, 0.1, 1);
  const FlatFaces faces(mesh);
  Rng rng(1);
  const auto weights = dual_weights(mesh, Heuristic::MinimumPerimeter, Vec3::UnitX(), rng);
  const FoldForest grown = grow_tree(faces, weights, 0);
  EXPECT_EQ(count_parts(mesh, grown), 1);
  const auto overlaps = [&](const FoldForest& tree) {
    return overlapping_pairs(faces, lay_panels(faces, tree)).size();
  };
  EXPECT_LT(2 * overlaps(grown), overlaps(lightest_forest(mesh, weights)));
}

TEST(ClassicNet, CutsOverlappingTreesIntoPartsThatAreFree) {
  const Mesh mesh = bumpy_sphere(3, 0.1, 1);
  const ClassicResult result = classic_net(mesh, {.heuristic = Heuristic::FlatTree, .directions = 3});
  EXPECT_EQ(result.ending, Ending::Exhausted);
  EXPECT_GT(result.overlaps, 0);
  EXPECT_GT(result.parts, 1);
  EXPECT_TRUE(verify_net(lay_flat(mesh, result.forest), mesh).valid());
}

TEST(ClassicNet, UnfoldsAConvexShapeWithoutCutting) {
  const Mesh mesh = bumpy_sphere(1, 0, 1);
  const ClassicResult result = classic_net(mesh);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_EQ(result.parts, 1);
}

}  // namespace
}  // namespace plico
