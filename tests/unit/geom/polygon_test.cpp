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

Polygon moved(Polygon polygon, const Vec2& by) {
  for (Vec2& p : polygon) p += by;
  return polygon;
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

TEST(Overlap, TouchingIsNotOverlapping) {
  EXPECT_FALSE(interiors_overlap_convex(kSquare, moved(kSquare, {2, 0})));    // a whole side in common
  EXPECT_FALSE(interiors_overlap_convex(kSquare, moved(kSquare, {2, 2})));    // a corner in common
  EXPECT_FALSE(interiors_overlap_convex(kSquare, moved(kSquare, {2, 0.5})));  // part of a side
  EXPECT_FALSE(interiors_overlap_convex(kSquare, moved(kSquare, {5, 0})));
}

TEST(Overlap, SharingAPointInsideIsOverlapping) {
  EXPECT_TRUE(interiors_overlap_convex(kSquare, kSquare));
  EXPECT_TRUE(interiors_overlap_convex(kSquare, moved(kSquare, {std::nextafter(2.0, 1.0), 0})));
  const Polygon inside = {{0.5, 0.5}, {1, 0.5}, {0.5, 1}};
  EXPECT_TRUE(interiors_overlap_convex(kSquare, inside));
  EXPECT_TRUE(interiors_overlap_convex(inside, kSquare));
  const Polygon bar = {{-1, 0.9}, {3, 0.9}, {3, 1.1}, {-1, 1.1}};  // crosses without any corner inside the other
  EXPECT_TRUE(interiors_overlap_convex(kSquare, bar));
}

TEST(Hull, KeepsOnlyCorners) {
  Polygon points = kSquare;
  points.insert(points.end(), {{1, 0}, {1, 1}, {2, 1}, {0, 0}});
  const Polygon hull = convex_hull(points);
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_DOUBLE_EQ(signed_area(hull), 4);
}

TEST(LeastRectangle, FindsATurnedRectangle) {
  Polygon turned;
  const double angle = 0.3;
  for (const Vec2& p : {Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(0, 1)})
    turned.emplace_back(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                        std::sin(angle) * p.x() + std::cos(angle) * p.y());
  const TurnedRectangle box = least_area_rectangle(turned);
  EXPECT_NEAR(box.size.x() * box.size.y(), 3, 1e-12);
  EXPECT_NEAR(std::max(box.size.x(), box.size.y()), 3, 1e-12);
}

}  // namespace
}  // namespace plico
