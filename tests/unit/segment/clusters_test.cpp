#include "plico/segment/clusters.h"

#include <gmock/gmock.h>

#include <numeric>
#include <set>

#include "plico/segment/given.h"
#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

std::vector<int> numbers_below(int n) {
  std::vector<int> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// A row of squares as one strip.
UnfoldingTrial strip(const Mesh& row, std::vector<std::pair<int, int>> overlaps) {
  UnfoldingTrial trial{std::vector<char>(row.num_edges(), 0), std::move(overlaps)};
  for (EdgeId e : row.edges()) trial.is_fold[e] = !row.is_boundary(e);
  return trial;
}

TEST(Clusters, AFaceJoinsWhenItOverlapsNoneThatIsIn) {
  const Mesh row{open_grid(4, 1)};
  const Foldability matrix(row, 1, [&](int) { return strip(row, {{0, 3}}); });
  // Breadth first, from 0: 0 1 2; from 1: 1 0 2; from 2: 2 and its neighbours 1 3; from 3: 3 2 1.
  EXPECT_EQ(matrix(0, 3), 0);
  EXPECT_EQ(matrix(0, 2), 1);
  EXPECT_EQ(matrix(1, 2), 2);
  EXPECT_EQ(matrix(1, 3), 1);
  EXPECT_EQ(matrix(3, 1), 1);
  EXPECT_EQ(matrix(2, 2), 1);
}

TEST(Clusters, FacesThatNeverLieTogetherArePartedThere) {
  const Mesh row{open_grid(8, 1)};
  std::vector<std::pair<int, int>> overlaps;
  for (int i = 0; i < 4; ++i)
    for (int j = 4; j < 8; ++j) overlaps.emplace_back(i, j);
  const Foldability matrix(row, 3, [&](int) { return strip(row, overlaps); });
  EXPECT_THAT(cluster(DualGraph(row), matrix, numbers_below(8), 2, 1), testing::ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
}

TEST(Clusters, PartsAreConnectedWhateverTheMatrix) {
  const Mesh mesh = dumbbell();
  // Rows of faces overlap every second row: clusters that make no connected parts by themselves.
  UnfoldingTrial trial{std::vector<char>(mesh.num_edges(), 1), {}};
  for (int f = 0; f < mesh.num_faces(); ++f)
    for (int g = f + 1; g < mesh.num_faces(); ++g)
      if ((f / 12 + g / 12) % 2 == 1) trial.overlaps.emplace_back(f, g);
  const Foldability matrix(mesh, 1, [&](int) { return trial; });
  for (int k : {1, 2, 5}) {
    const std::vector<int> part = cluster(DualGraph(mesh), matrix, numbers_below(mesh.num_faces()), k, 3);
    const int count = *std::max_element(part.begin(), part.end()) + 1;
    EXPECT_LE(count, k);
    EXPECT_EQ(by_labels(mesh, part).num_parts(), count);
  }
}

TEST(RandomParts, AreConnectedAndAsManyAsAskedFor) {
  const Mesh mesh{geodesic_sphere(2)};
  for (int k : {1, 2, 7, 80}) {
    const std::vector<int> part = random_parts(DualGraph(mesh), numbers_below(80), k, k);
    EXPECT_EQ(std::set<int>(part.begin(), part.end()).size(), static_cast<std::size_t>(k));
    EXPECT_EQ(by_labels(mesh, part).num_parts(), k);
  }
}

}  // namespace
}  // namespace plico
