// Overlaps that only the finished layout shows are cut apart.
#include "plico/unfold/parts.h"

#include <gtest/gtest.h>

#include "plico/shapes/shapes.h"

namespace plico {
namespace {

// Faces 0 .. n - 1 in a row, each folded to the next.
FoldForest chain_of(const Mesh& mesh, int n) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (FaceId f : mesh.faces()) {
    if (f + 1 >= n) break;
    for (HalfedgeId h : mesh.halfedges(f))
      if (mesh.twin(h).valid() && mesh.face(mesh.twin(h)) == f + 1) forest.is_fold[mesh.edge(h)] = 1;
  }
  return forest;
}

Mesh row_of_squares(int n) {
  PolygonSoup soup;
  for (int i = 0; i <= n; ++i) {
    soup.points.emplace_back(i, 0, 0);
    soup.points.emplace_back(i, 1, 0);
  }
  for (int i = 0; i < n; ++i) soup.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return Mesh(soup);
}

TEST(PartPairs, CutsOffTheSmallerBranch) {
  const Mesh row = row_of_squares(6);
  FoldForest forest = chain_of(row, 6);
  part_pairs(row, forest, {{1, 4}});
  const Unfolding net = lay_flat(row, forest);
  EXPECT_EQ(net.part, (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(PartPairs, LeavesWhatAnEarlierCutHasParted) {
  const Mesh row = row_of_squares(6);
  FoldForest forest = chain_of(row, 6);
  part_pairs(row, forest, {{1, 4}, {0, 5}, {3, 4}, {0, 2}});
  EXPECT_EQ(lay_flat(row, forest).part, (std::vector<int>{0, 0, 1, 1, 2, 2}));
}

}  // namespace
}  // namespace plico
