#include "plico/mesh/flat_regions.h"

#include <gtest/gtest.h>

#include "plico/mesh/check.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/simplify.h"
#include "plico/shapes/named_shapes.h"

namespace plico {
namespace {

TEST(FlatRegions, ACubeOfManySquaresHasSixFacesAndEightVertices) {
  const Mesh mesh(make_shape("quad-cube"));
  const FlatRegions regions = flat_regions(mesh);
  const Mesh whole(regions.soup);
  EXPECT_EQ(whole.num_faces(), 6);
  EXPECT_EQ(whole.num_vertices(), 8);
  EXPECT_EQ(regions.num_merged, 6);
  EXPECT_NEAR(volume(whole), volume(mesh), 1e-12);
  for (FaceId f : mesh.faces()) EXPECT_GT(normal(whole, FaceId(regions.region[f])).dot(normal(mesh, f)), 1 - 1e-12);
}

TEST(FlatRegions, SolidsCutIntoTrianglesGetTheirPolygonsBack) {
  for (const char* name : {"cube", "prism", "truncated-cube"}) {
    const PolygonSoup solid = make_shape(name);
    const Mesh whole(flat_regions(Mesh(triangulated(solid)), 1e-9).soup);
    EXPECT_EQ(whole.num_faces(), solid.num_faces()) << name;
    EXPECT_EQ(whole.num_vertices(), solid.num_points()) << name;
    EXPECT_TRUE(is_closed(whole)) << name;
  }
}

TEST(FlatRegions, ShapesWithoutFlatNeighboursStayAsTheyAre) {
  const PolygonSoup bird = make_shape("bird");
  const FlatRegions regions = flat_regions(Mesh(bird));
  EXPECT_EQ(regions.num_merged, 0);
  EXPECT_EQ(regions.soup.num_faces(), bird.num_faces());
}

// A square with a square hole, in four trapezoids.
TEST(FlatRegions, ARegionWithAHoleKeepsItsFaces) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  for (int i = 0; i < 4; ++i) soup.add_face({i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i});
  const FlatRegions regions = flat_regions(Mesh(soup));
  EXPECT_EQ(regions.soup.num_faces(), 4);
  EXPECT_EQ(regions.num_merged, 0);
}

TEST(FlatRegions, OpenSheetsBecomeOnePolygon) {
  const FlatRegions regions = flat_regions(Mesh(make_shape("grid")));
  EXPECT_EQ(regions.soup.num_faces(), 1);
  EXPECT_EQ(regions.soup.num_points(), 4);
  EXPECT_TRUE(check_mesh(regions.soup).usable());
}

}  // namespace
}  // namespace plico
