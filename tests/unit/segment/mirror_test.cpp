#include "plico/segment/mirror.h"

#include <gmock/gmock.h>

#include <limits>

#include "plico/mesh/measures.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::Each;
using testing::Ge;

TEST(Mirror, ImagesOfImagesAreTheFacesThemselves) {
  for (const Mesh& mesh : {Mesh(spiked(Mesh(cube()), 2)), Mesh(spiked(Mesh(octahedron()), 2)), Mesh(prism(5))}) {
    const auto image = mirror_images(mesh);
    ASSERT_TRUE(image.has_value());
    for (FaceId f : mesh.faces()) {
      EXPECT_EQ((*image)[(*image)[f]], f);
      EXPECT_NEAR(area(mesh, f), area(mesh, FaceId((*image)[f])), 1e-9);
    }
  }
}

TEST(Mirror, AShapeWithoutAPlaneHasNoImages) {
  PolygonSoup skew = cube();
  skew.points[0] += Vec3(0.1, 0.2, 0.3);
  skew.points[3] += Vec3(0.3, -0.1, 0.2);
  EXPECT_FALSE(mirror_images(Mesh(skew)).has_value());
}

TEST(Mirror, EveryPartHasItsImage) {
  for (const Mesh& mesh : {Mesh(spiked(Mesh(cube()), 2)), Mesh(spiked(Mesh(octahedron()), 3))}) {
    const auto image = mirror_images(mesh);
    ASSERT_TRUE(image.has_value());
    for (int count : {2, 5, 9}) {
      const NeckCutOptions options{
          .worst_score = std::numeric_limits<double>::infinity(), .max_parts = count, .neck = {}};
      const std::vector<int> part = cut_mirrored(DualGraph(mesh), components(mesh).of_face, *image, options);
      const std::vector<int> partner = mirror_partners(part, *image);
      EXPECT_THAT(partner, Each(Ge(0)));
      EXPECT_LE(static_cast<int>(partner.size()), count);
      EXPECT_GE(static_cast<int>(partner.size()), count - 1);
    }
  }
}

TEST(Mirror, APartOnOneSideOnlyHasNoPartner) {
  const std::vector<int> image{1, 0, 3, 2};
  EXPECT_THAT(mirror_partners({0, 0, 1, 2}, image), testing::ElementsAre(0, 2, 1));
  EXPECT_THAT(mirror_partners({0, 1, 1, 1}, image), testing::ElementsAre(-1, -1));
}

}  // namespace
}  // namespace plico
