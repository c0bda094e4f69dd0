#include "plico/segment/wishes.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/segment/rearrange.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(FaceWishes, ListsAreReadWithRanges) {
  EXPECT_THAT(face_list("7,2-4,3", "keep"), ElementsAre(2, 3, 4, 7));
  for (const char* wrong : {"", ",", "3-", "-3", "5-3", "3 4", "3,", "x", "99999999999"})
    EXPECT_THROW(face_list(wrong, "keep"), InvalidOption) << wrong;
}

TEST(FaceWishes, EveryPairOfAGroupComesApart) {
  EXPECT_THAT(pairs_apart({.keep = {}, .apart = {{9, 4, 6}, {4, 6}}}), ElementsAre(Pair(4, 6), Pair(4, 9), Pair(6, 9)));
}

TEST(FaceWishes, WhatIsKeptTogetherIsNeverCut) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  const FaceWishes wishes{.keep = {{0, 23}}, .apart = {}};
  DualGraph graph(star);
  hold_together(graph, wishes);
  const std::vector<int> part = cut_limbs(graph, components(star).of_face);
  EXPECT_EQ(part[0], part[23]);
  EXPECT_NO_THROW(check_kept(wishes, part));
}

TEST(FaceWishes, AWallOfFacesToBeApartLeavesNoWay) {
  const Mesh mesh{tetrahedron()};
  DualGraph graph(mesh);
  EXPECT_THROW(hold_together(graph, {.keep = {{0, 1}}, .apart = {{0, 1}}}), InvalidOption);
}

TEST(FaceWishes, NamesGoToThePartsOfTheirFaces) {
  Segmentation parts{{0, 1, 0}, {"A", "B"}};
  name_parts(parts, "1  tail fin\r\n\n2 A\n", "names.txt");
  EXPECT_THAT(parts.names, ElementsAre("A", "tail fin"));
}

TEST(FaceWishes, NamesThatFitNoPartAreRefused) {
  for (const char* wrong : {"3 head", "head", "1", "0 a\n2 b", "0 B", "-1 a"}) {
    Segmentation parts{{0, 1, 0}, {"A", "B"}};
    EXPECT_THROW(name_parts(parts, wrong, "names.txt"), InvalidInput) << wrong;
  }
}

}  // namespace
}  // namespace plico
