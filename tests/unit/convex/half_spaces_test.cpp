#include "plico/convex/half_spaces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/base/rng.h"

namespace plico {
namespace {

std::vector<Plane> unit_cube() {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0}) planes.push_back({sign * Vec3::Unit(axis), 1});
  return planes;
}

double worst_height(const std::vector<Plane>& planes, const Vec3& p) {
  double worst = -INFINITY;
  for (const Plane& plane : planes) worst = std::max(worst, plane.height(p));
  return worst;
}

TEST(LowestPoint, OfACubeIsACorner) {
  const std::vector<Plane> cube = unit_cube();
  const auto point = lowest_point({cube, {}}, {1, 2, 3}, {0.1, 0.2, 0.3}, 100);
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point - Vec3(-1, -1, -1)).norm(), 0, 1e-9);
}

TEST(LowestPoint, OfABallLiesAgainstTheSlope) {
  const auto point = lowest_point({{}, {}}, {0, 0, 2}, {1, 1, 1}, 3);
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point - Vec3(1, 1, -2)).norm(), 0, 1e-12);
}

TEST(LowestPoint, OfNothingIsNone) {
  const std::vector<Plane> apart = {{Vec3::UnitX(), -1}, {-Vec3::UnitX(), -1}};
  EXPECT_FALSE(lowest_point({apart, {}}, {1, 0, 0}, {0, 0, 0}, 10));
}

TEST(LowestPoint, StaysOnPlanesGivenAsSuch) {
  const std::vector<Plane> cube = unit_cube();
  const std::vector<Plane> on = {{Vec3::UnitX(), 0.5}, {Vec3(0, 0.6, 0.8), 0.1}};
  const auto point = lowest_point({cube, on}, {0, 0, 1}, {0, 0, 0}, 10);
  ASSERT_TRUE(point);
  EXPECT_NEAR(on[0].height(*point), 0, 1e-9);
  EXPECT_NEAR(on[1].height(*point), 0, 1e-9);
  EXPECT_NEAR(point->y(), 1, 1e-9);
}

TEST(ClosestPoint, OfAPointInsideIsItself) {
  const std::vector<Plane> cube = unit_cube();
  const auto point = closest_point({cube, {}}, {0.3, 0.4, 0.5}, 10);
  ASSERT_TRUE(point);
  EXPECT_EQ(*point, Vec3(0.3, 0.4, 0.5));
}

TEST(ClosestPoint, OfACubeIsOnItsFaceEdgeOrCorner) {
  const std::vector<Plane> cube = unit_cube();
  EXPECT_NEAR((*closest_point({cube, {}}, {3, 0, 0.5}, 10) - Vec3(1, 0, 0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR((*closest_point({cube, {}}, {3, 5, 0.5}, 10) - Vec3(1, 1, 0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR((*closest_point({cube, {}}, {3, 5, 9}, 20) - Vec3(1, 1, 1)).norm(), 0, 1e-9);
}

TEST(ClosestPoint, FartherThanTheRadiusIsNone) {
  const std::vector<Plane> cube = unit_cube();
  EXPECT_FALSE(closest_point({cube, {}}, {5, 0, 0}, 1));
}

TEST(ClosestPoint, OfRandomPlanesIsBelowAllAndNoSampleIsNearer) {
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto random = [&] {
      const double x = rng.normal(), y = rng.normal();
      return Vec3(x, y, rng.normal());
    };
    std::vector<Plane> planes;
    for (int i = 0; i < 20; ++i) {
      const Vec3 normal = random().normalized();
      planes.push_back({normal, rng.uniform(0.2, 1)});  // the origin is below all of them
    }
    const Vec3 target = 3 * random();
    const auto point = closest_point({planes, {}}, target, 100);
    ASSERT_TRUE(point);
    EXPECT_LT(worst_height(planes, *point), 1e-9);
    for (int i = 0; i < 200; ++i) {
      const Vec3 sample = *point + 0.3 * random();
      if (worst_height(planes, sample) > 0) continue;
      EXPECT_GE((sample - target).norm(), (*point - target).norm() - 1e-9);
    }
  }
}

}  // namespace
}  // namespace plico
