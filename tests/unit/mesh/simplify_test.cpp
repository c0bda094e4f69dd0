#include "plico/mesh/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "plico/mesh/measures.h"
#include "plico/shapes/named_shapes.h"
#include "plico/shapes/shapes.h"
#include "triangle_sheet.h"

namespace plico {
namespace {

// Wavy when `height` is above 0.
Mesh sheet(int n, double height) {
  return triangle_sheet(n, [height](int x, int y) { return height * ((x * y) % 3); });
}

TEST(Simplify, AFlatOpenSheetKeepsItsOutline) {
  const Mesh mesh = sheet(12, 0), small(simplified(mesh, {.faces = 20, .evenness = 1e-6}));
  EXPECT_LE(small.num_faces(), 20);
  EXPECT_NEAR(surface_area(small), 144, 1e-3);
  EXPECT_LT(vertex_distance(mesh.soup(), small.soup()), 1e-3);
  EXPECT_EQ(genus(small), genus(mesh));
}

TEST(Simplify, AWavySheetStaysOnePieceWithOneBoundary) {
  const Mesh mesh = sheet(15, 0.2), small(simplified(mesh, {.faces = 60}));
  EXPECT_LE(small.num_faces(), 60);
  EXPECT_EQ(components(small).count, 1);
  EXPECT_FALSE(is_closed(small));
  EXPECT_NEAR(surface_area(small), surface_area(mesh), 0.1 * surface_area(mesh));
}

TEST(Simplify, SharpEdgesOfASolidStay) {
  const Mesh mesh(triangulated(make_shape("quad-cube", {.faces = 600})));
  const Mesh small(simplified(mesh, {.faces = 24, .evenness = 1e-4, .keep_sharp = true}));
  EXPECT_LE(small.num_faces(), 24);
  EXPECT_NEAR(volume(small), volume(mesh), 1e-3 * volume(mesh));
}

TEST(Simplify, LeftAndRightOfASymmetricShapeAreEqualAndClosed) {
  const Mesh mesh(make_shape("bird", {.faces = 2000}));
  const std::optional<MirrorPlane> plane = mirror_plane(mesh);
  ASSERT_TRUE(plane.has_value());
  const std::optional<PolygonSoup> soup = simplified_alike(mesh, *plane, {.faces = 200});
  ASSERT_TRUE(soup.has_value());
  const Mesh small(*soup);
  EXPECT_TRUE(is_closed(small));
  EXPECT_LE(small.num_faces(), 200);
  EXPECT_GT(small.num_faces(), 190);
  EXPECT_EQ(genus(small), genus(mesh));
  for (int v = 0; v < small.num_vertices(); ++v) {
    const Vec3 image = plane->image(small.point(VertexId(v)));
    double least = 1;
    for (const Vec3& p : soup->points) least = std::min(least, (p - image).norm());
    EXPECT_LT(least, 1e-12);
  }
}

TEST(Simplify, ASheetThatOnlyTouchesItsPlaneIsNotHalved) {
  EXPECT_FALSE(upper_half(sheet(3, 0), {Vec3::Zero(), Vec3::UnitZ()}).has_value());
  PolygonSoup corner;  // no two corners of this are alike
  corner.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 5}};
  corner.add_face({0, 1, 3});
  corner.add_face({1, 2, 3});
  EXPECT_FALSE(mirror_plane(Mesh(corner)).has_value());
}

TEST(Simplify, DistanceIsThatOfTheFarthestVertex) {
  PolygonSoup a = cube(), b = cube();
  EXPECT_EQ(vertex_distance(a, b), 0);
  const double side = (a.points[a.corners[1]] - a.points[a.corners[0]]).norm();
  for (Vec3& p : b.points) p *= 2;
  EXPECT_NEAR(vertex_distance(a, b), side / 2 * std::sqrt(3.0), 1e-12);
}

}  // namespace
}  // namespace plico
