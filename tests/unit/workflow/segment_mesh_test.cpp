#include "plico/workflow/segment_mesh.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/named_shapes.h"
#include "plico/shapes/shapes.h"
#include "plico/workflow/parts_file.h"

namespace plico {
namespace {

TEST(SegmentMesh, EveryPartOfAStarIsProven) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  const Kit result = segment_mesh(star);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_EQ(result.parts.num_parts(), 6);
  EXPECT_EQ(result.num_proven(), 6);
  const FoldFile file = parts_file(star, result);
  const FoldFile again = read_fold(write_fold(file));
  EXPECT_TRUE(verify_parts(parts_claim(again).value(), again.net, star).valid());
}

TEST(SegmentMesh, FewestKeepsWhatFoldsInOnePiece) {
  SegmentOptions options;
  options.wish = PartsWish::Fewest;
  EXPECT_EQ(segment_mesh(Mesh(cube()), options).parts.num_parts(), 1);
}

TEST(SegmentMesh, ASurfaceThroughItselfIsSaidAndParted) {
  // A long strip of squares, bent until its end runs through its beginning.
  PolygonSoup soup;
  Vec3 at(0, 0, 0);
  for (int i = 0; i <= 5; ++i) {
    soup.points.push_back(at);
    soup.points.push_back(at + Vec3(0, 1, 0));
    const double turn = i * 80 * kPi / 180;
    at += Vec3(std::cos(turn), 0, std::sin(turn));
    if (i > 0) soup.add_face({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  const Mesh strip{soup};
  SegmentOptions options;
  options.wish = PartsWish::Fewest;
  const Kit result = segment_mesh(strip, options);
  EXPECT_EQ(result.parts.num_parts(), 2);
  EXPECT_EQ(result.ending, Ending::Found);
  ASSERT_FALSE(result.notes.empty());
  EXPECT_THAT(result.notes[0], testing::HasSubstr("run through each other (0-4)"));
}

TEST(SegmentMesh, AsManyPartsAsAreAskedFor) {
  const Mesh mesh{octahedron()};
  SegmentOptions options;
  options.wish = PartsWish::Exactly;
  for (int n : {1, 3, 8}) {
    options.parts = n;
    const Kit result = segment_mesh(mesh, options);
    EXPECT_EQ(result.parts.num_parts(), n);
    EXPECT_EQ(result.num_proven(), n);
  }
  options.parts = 9;
  EXPECT_THROW(segment_mesh(mesh, options), InvalidOption);
}

TEST(SegmentMesh, ARunThatIsOverLeavesValidNets) {
  const Mesh dog{make_shape("dog", {.faces = 100})};
  const Kit result = segment_mesh(dog, {}, limited({}, 0));
  EXPECT_EQ(result.ending, Ending::TimedOut);
  EXPECT_TRUE(result.verdict.valid());
  const FoldFile file = parts_file(dog, result);
  EXPECT_TRUE(verify_parts(parts_claim(file).value(), file.net, dog).valid());
}

TEST(SegmentMesh, ThreadsDoNotMatter) {
  const Mesh dog{make_shape("dog", {.faces = 100})};
  const Kit one = segment_mesh(dog), two = segment_mesh(dog, {}, {.threads = 2});
  EXPECT_EQ(write_fold(parts_file(dog, one)), write_fold(parts_file(dog, two)));
}

TEST(SegmentMesh, AssemblyBeginsWithTheLargestAndGoesOnAlongSeams) {
  const Mesh row{open_grid(6, 1)};
  const Segmentation parts = segmentation_by_labels(row, {0, 0, 0, 1, 2, 2});  // A, B = {4, 5}, C between them
  EXPECT_THAT(assembly_steps(row, parts), testing::ElementsAre(1, 3, 2));
}

TEST(SegmentMesh, PartsThatFitNoPageAreCutOn) {
  SegmentOptions options;
  options.wish = PartsWish::Fewest;
  options.page = PageFit{Vec2(25, 25), 10};  // of a cube of side 1 two faces fit, also three around a corner
  const Mesh mesh{cube()};
  const double side = length(mesh, EdgeId(0));
  options.page->scale /= side;
  const Kit result = segment_mesh(mesh, options);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_GE(result.parts.num_parts(), 2);
  options.page->room = Vec2(9, 9);
  const Kit too_small = segment_mesh(mesh, options);
  EXPECT_EQ(too_small.ending, Ending::Exhausted);
  EXPECT_EQ(too_small.parts.num_parts(), 6);
  EXPECT_EQ(too_small.notes.size(), 6u);
  EXPECT_THAT(too_small.notes[0], testing::HasSubstr("does not fit 9 x 9 mm"));
}

}  // namespace
}  // namespace plico
