#include "plico/geom/convex2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "plico/geom/polygon.h"

namespace plico {
namespace {

using Corners = std::vector<Vec2>;

const Corners kTwoByTwo = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

Corners moved_by(Corners polygon, const Vec2& by) {
  for (Vec2& p : polygon) p += by;
  return polygon;
}

double area(const Corners& polygon) { return polygon.size() < 3 ? 0 : signed_area(polygon); }

TEST(Clipped, LeavesWhatLiesInBoth) {
  EXPECT_DOUBLE_EQ(area(clipped({{1, 1}, {3, 1}, {3, 3}, {1, 3}}, kTwoByTwo)), 1);
  EXPECT_DOUBLE_EQ(area(clipped({{0.5, 0.5}, {1.5, 0.5}, {1, 1}}, kTwoByTwo)), 0.25);
  EXPECT_DOUBLE_EQ(area(clipped({{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, kTwoByTwo)), 4);
}

TEST(Clipped, LeavesNoAreaWhereNothingLiesInBoth) {
  EXPECT_EQ(area(clipped({{5, 0}, {6, 0}, {6, 1}}, kTwoByTwo)), 0);
  EXPECT_EQ(area(clipped({{2, 0}, {3, 0}, {3, 2}}, kTwoByTwo)), 0);  // they touch along a side
}

TEST(Clipped, CutsACornersThatIsNotConvex) {
  // An L of which the window keeps both arms.
  const Corners l = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  EXPECT_DOUBLE_EQ(area(clipped(l, kTwoByTwo)), 3);
}

TEST(SideSeparates, CountsATouchOfTheGivenDepthAsApart) {
  const auto depth = [](double d) { return [d](const Vec2& side) { return d * side.norm(); }; };
  const Corners beside = {{1.9, 0}, {4, 0}, {4, 2}, {1.9, 2}};
  EXPECT_FALSE(side_separates(kTwoByTwo, beside, depth(0)));
  EXPECT_FALSE(side_separates(kTwoByTwo, beside, depth(0.09)));
  EXPECT_TRUE(side_separates(kTwoByTwo, beside, depth(0.11)));
  // A corner before a side: only the side's line separates.
  const Corners diamond = {{3.1, 0}, {4, 1}, {3.1, 2}, {2.1, 1}};
  EXPECT_TRUE(side_separates(kTwoByTwo, diamond, depth(0)));
}

TEST(ConvexPieces, AreTheCornersItselfOrItsTriangles) {
  EXPECT_EQ(convex_pieces(kTwoByTwo).size(), 1u);
  const Corners l = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  double sum = 0;
  for (const auto& piece : convex_pieces(l)) sum += area(piece);
  EXPECT_EQ(convex_pieces(l).size(), 4u);
  EXPECT_DOUBLE_EQ(sum, 7);
}

TEST(Overlap, TouchingIsNotOverlapping) {
  EXPECT_FALSE(interiors_overlap_convex(kTwoByTwo, moved_by(kTwoByTwo, {2, 0})));    // a whole side in common
  EXPECT_FALSE(interiors_overlap_convex(kTwoByTwo, moved_by(kTwoByTwo, {2, 2})));    // a corner in common
  EXPECT_FALSE(interiors_overlap_convex(kTwoByTwo, moved_by(kTwoByTwo, {2, 0.5})));  // part of a side
  EXPECT_FALSE(interiors_overlap_convex(kTwoByTwo, moved_by(kTwoByTwo, {5, 0})));
}

TEST(Overlap, SharingAPointInsideIsOverlapping) {
  EXPECT_TRUE(interiors_overlap_convex(kTwoByTwo, kTwoByTwo));
  EXPECT_TRUE(interiors_overlap_convex(kTwoByTwo, moved_by(kTwoByTwo, {std::nextafter(2.0, 1.0), 0})));
  const Corners inside = {{0.5, 0.5}, {1, 0.5}, {0.5, 1}};
  EXPECT_TRUE(interiors_overlap_convex(kTwoByTwo, inside));
  EXPECT_TRUE(interiors_overlap_convex(inside, kTwoByTwo));
  const Corners bar = {{-1, 0.9}, {3, 0.9}, {3, 1.1}, {-1, 1.1}};  // crosses without any corner inside the other
  EXPECT_TRUE(interiors_overlap_convex(kTwoByTwo, bar));
}

TEST(Hull, KeepsOnlyCorners) {
  Corners points = kTwoByTwo;
  points.insert(points.end(), {{1, 0}, {1, 1}, {2, 1}, {0, 0}});
  const Corners hull = convex_hull(points);
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_DOUBLE_EQ(signed_area(hull), 4);
}

TEST(LeastRectangle, FindsATurnedRectangle) {
  Corners turned;
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
