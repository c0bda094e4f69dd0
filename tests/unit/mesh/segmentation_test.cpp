#include "plico/mesh/segmentation.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::ElementsAre;

TEST(Segmentation, PartsAreNumberedByAreaThenByTheirFirstFace) {
  const Segmentation parts = segmentation_by_labels(Mesh(cube()), {7, 7, -1, 9, 9, 9});
  EXPECT_THAT(parts.part, ElementsAre(1, 1, 2, 0, 0, 0));
  EXPECT_THAT(parts.names, ElementsAre("A", "B", "C"));
  EXPECT_THAT(faces_of_parts(parts)[1], ElementsAre(FaceId(0), FaceId(1)));
}

TEST(Segmentation, SeamsAreTheEdgesBetweenParts) {
  const Mesh mesh{cube()};
  EXPECT_EQ(seams(mesh, segmentation_by_labels(mesh, {0, 1, 1, 1, 1, 1})).size(), 4u);
  EXPECT_TRUE(seams(mesh, segmentation_by_labels(mesh, {0, 0, 0, 0, 0, 0})).empty());
}

TEST(Segmentation, LabelsOfAnotherMeshAreRefused) {
  EXPECT_THROW(segmentation_by_labels(Mesh(cube()), {0, 1}), InvalidInput);
}

TEST(Segmentation, NamesGoOnAfterZ) {
  EXPECT_EQ(part_name(0), "A");
  EXPECT_EQ(part_name(25), "Z");
  EXPECT_EQ(part_name(26), "AA");
  EXPECT_EQ(part_name(27), "AB");
  EXPECT_EQ(part_name(51), "AZ");
  EXPECT_EQ(part_name(52), "BA");
  EXPECT_EQ(part_name(701), "ZZ");
  EXPECT_EQ(part_name(702), "AAA");
}

}  // namespace
}  // namespace plico
