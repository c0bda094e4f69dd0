#include "plico/geom/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace plico {
namespace {

using Polygon = std::vector<Vec2>;

const Polygon kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Polygon kArrow = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};  // not convex at (1, 1)

double area_of(const Polygon& polygon, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Polygon triangle = {polygon[a], polygon[b], polygon[c]};
    EXPECT_GT(signed_area(triangle), 0);
    sum += signed_area(triangle);
  }
  return sum;
}

TEST(Polygon, Measures) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 4);
  EXPECT_DOUBLE_EQ(signed_area(Polygon(kSquare.rbegin(), kSquare.rend())), -4);
  EXPECT_DOUBLE_EQ(perimeter(kSquare), 8);
  EXPECT_TRUE(centroid(kSquare).isApprox(Vec2(1, 1)));
}

TEST(Polygon, ConvexOrNot) {
  EXPECT_TRUE(is_convex(kSquare));
  EXPECT_FALSE(is_convex(kArrow));
  EXPECT_TRUE(is_convex(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));  // a collinear corner is allowed
}

TEST(Triangulate, CoversThePolygonOnce) {
  EXPECT_EQ(triangulate(kArrow).size(), 2u);
  EXPECT_DOUBLE_EQ(area_of(kArrow, triangulate(kArrow)), signed_area(kArrow));
  const Polygon comb = {{0, 0}, {6, 0}, {6, 3}, {5, 1}, {4, 3}, {3, 1}, {2, 3}, {1, 1}, {0, 3}};
  EXPECT_EQ(triangulate(comb).size(), comb.size() - 2);
  EXPECT_DOUBLE_EQ(area_of(comb, triangulate(comb)), signed_area(comb));
}

}  // namespace
}  // namespace plico
