#include "plico/segment/must_part.h"

#include <gmock/gmock.h>

#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

TEST(MustPart, AreTakenApartAtTheCheapestPlace) {
  const Mesh mesh = dumbbell();
  const int last = mesh.num_faces() - 1;
  const std::vector<int> part =
      part_pairs(DualGraph(mesh), std::vector<int>(mesh.num_faces(), 0), {{0, last}, {1, last}, {2, last - 1}});
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1);
  for (int f = 0; f < 6 * 12; ++f) EXPECT_NE(part[f], part[last - f]);
}

TEST(MustPart, GroupsTakeTheColoursThatCostLess) {
  // Pairs named the wrong way round for one cut: both groups still part at the tube.
  const Mesh mesh = dumbbell();
  const int last = mesh.num_faces() - 1;
  const std::vector<int> part =
      part_pairs(DualGraph(mesh), std::vector<int>(mesh.num_faces(), 0), {{0, last}, {5, last - 4}, {7, last - 9}});
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1);
}

TEST(MustPart, ThreeFacesAgainstEachOtherNeedThreeParts) {
  const Mesh row{open_grid(9, 1)};
  const std::vector<int> part = part_pairs(DualGraph(row), std::vector<int>(9, 0), {{0, 4}, {4, 8}, {0, 8}});
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 2);
  EXPECT_NE(part[0], part[4]);
  EXPECT_NE(part[4], part[8]);
}

TEST(MustPart, WithoutPairsNothingIsCut) {
  const Mesh row{open_grid(3, 1)};
  EXPECT_THAT(part_pairs(DualGraph(row), {0, 0, 0}, {}), testing::Each(0));
}

}  // namespace
}  // namespace plico
