#include "plico/geom/convex3.h"

#include <gtest/gtest.h>

#include <map>

#include "plico/base/rng.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

std::vector<Vec3> box_points(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return points;
}
ConvexPolyhedron box(const Vec3& low, const Vec3& high) { return convex_hull(box_points(low, high)); }

// Every edge is run along once in each direction, and Euler's formula holds.
void expect_closed(const ConvexPolyhedron& body) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& facet : body.facets)
    for (std::size_t i = 0; i < facet.corners.size(); ++i)
      ++sides[{facet.corners[i], facet.corners[(i + 1) % facet.corners.size()]}];
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.contains({side.second, side.first}));
  }
  EXPECT_EQ(static_cast<int>(body.points.size() + body.facets.size()) - static_cast<int>(sides.size()) / 2, 2);
}

TEST(Hull3, OfTheGridPointsOfACubeIsTheCube) {
  std::vector<Vec3> points;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) points.emplace_back(x, y, z);
  const ConvexPolyhedron hull = convex_hull(points);
  expect_closed(hull);
  EXPECT_EQ(volume(hull), 27);
  EXPECT_LT((centroid(hull) - Vec3(1.5, 1.5, 1.5)).norm(), 1e-14);
}

TEST(Hull3, NoPointLiesAboveAFacet) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < 100; ++i) {  // a coarse grid, so that many points are coplanar, collinear or equal
      const double x = rng.below(6), y = rng.below(6);
      points.emplace_back(0.1 * x, 0.1 * y, 0.1 * rng.below(6));
    }
    const ConvexPolyhedron hull = convex_hull(points);
    expect_closed(hull);
    for (const auto& facet : hull.facets)
      for (const Vec3& p : points)
        ASSERT_GE(
            orient3d(hull.points[facet.corners[0]], hull.points[facet.corners[1]], hull.points[facet.corners[2]], p),
            0);
  }
}

TEST(Hull3, IsEmptyWithoutFourPointsThatSpanSpace) {
  EXPECT_TRUE(convex_hull(std::vector<Vec3>{}).empty());
  EXPECT_TRUE(convex_hull(std::vector<Vec3>(7, Vec3(1, 2, 3))).empty());
  EXPECT_TRUE(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 2, 0}}).empty());
}

TEST(Clip3, TwoSidesOfACutMakeTheWhole) {
  Rng rng(1);
  const ConvexPolyhedron cube = box({0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 100; ++i) {
    const double x = rng.normal(), y = rng.normal();
    const Vec3 normal = Vec3(x, y, rng.normal()).normalized();
    const Plane plane{normal, normal.dot(Vec3(0.5, 0.5, 0.5)) + rng.uniform(-0.3, 0.3)};
    const ConvexPolyhedron below = clip(cube, plane, 7), above = clip(cube, plane.flipped(), 7);
    expect_closed(below);
    EXPECT_NEAR(volume(below) + volume(above), 1, 1e-14);
    EXPECT_EQ(below.facets.back().source, 7);
    EXPECT_NEAR(vector_area(below, below.facets.back()).dot(normal),
                -vector_area(above, above.facets.back()).dot(normal), 1e-14);
  }
}

TEST(Clip3, PlaneThroughAFacetKeepsAllOrNothing) {
  const ConvexPolyhedron cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(volume(clip(cube, {Vec3::UnitZ(), 1}, 0)), 1);
  EXPECT_EQ(volume(clip(cube, {Vec3::UnitZ(), 0}, 0)), 0);
  EXPECT_TRUE(clip(cube, {Vec3::UnitZ(), -0.5}, 0).empty());
}

TEST(UnionVolume, CountsWhatIsSharedOnce) {
  const std::vector<ConvexPolyhedron> cubes = {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}),
                                               box({0, 0, 0}, {1, 1, 1}), box({9, 9, 9}, {10, 10, 10})};
  EXPECT_NEAR(union_volume(cubes), 8 + 8 - 1 + 1, 1e-13);
  EXPECT_NEAR(volume(intersection(cubes[0], cubes[1], 0)), 1, 1e-14);
}

// Three points on a line but for rounding make a triangle without area, whose plane must not part anything.
TEST(UnionVolume, IsNotMisledByNeedles) {
  std::vector<ConvexPolyhedron> pair;
  for (int k = 0; k < 2; ++k) {
    std::vector<Vec3> points;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) points.emplace_back(0.1 * (x + k), 0.1 * y, 0.1 * (z + y));
    pair.push_back(convex_hull(points));
  }
  EXPECT_NEAR(volume(pair[0]), 0.027, 1e-14);
  EXPECT_NEAR(union_volume(pair), 0.036, 1e-14);
  EXPECT_NEAR(volume(intersection(pair[0], pair[1], 0)), 0.018, 1e-14);
  for (const auto& facet : pair[0].facets)
    for (const Vec3& p : pair[0].points) EXPECT_LT(facet.plane.height(p), 1e-15);
}

TEST(SeparatingPlane, IsFoundExactlyWhenBodiesAreApart) {
  const ConvexPolyhedron cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(separating_plane(cube, box({1, 0, 0}, {2, 1, 1}), 0));  // touching
  EXPECT_FALSE(separating_plane(cube, box({0.9, 0.9, 0.9}, {2, 2, 2}), 1e-9));
  // Two crossed edges: no facet separates them.
  const ConvexPolyhedron low = convex_hull(std::vector<Vec3>{{-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}});
  const ConvexPolyhedron high = convex_hull(std::vector<Vec3>{{0, -1, 0.1}, {0, 1, 0.1}, {1, 0, 1.1}, {-1, 0, 1.1}});
  const auto plane = separating_plane(low, high, 0);
  ASSERT_TRUE(plane);
  for (const Vec3& p : low.points) EXPECT_EQ(side_of_plane(*plane, p), -1);
  for (const Vec3& p : high.points) EXPECT_EQ(side_of_plane(*plane, p), 1);
}

}  // namespace
}  // namespace plico
