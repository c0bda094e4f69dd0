#include "plico/geom/predicates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plico {
namespace {

TEST(Orient2d, SignFollowsTheTurn) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

// Points near the line through (12, 12) and (24, 24), one unit in the last place apart: plain doubles get many wrong
// (Kettner et al., Classroom examples of robustness problems, 2008). On this grid the sign is that of y - x.
TEST(Orient2d, IsExactNextToTheLine) {
  const double ulp = std::ldexp(1.0, -53);
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Vec2 p(0.5 + i * ulp, 0.5 + j * ulp);
      const int expected = (p.y() > p.x()) - (p.y() < p.x());
      ASSERT_EQ(orient2d({12, 12}, {24, 24}, p), expected) << i << " " << j;
    }
  }
}

TEST(Orient2d, ObeysItsSymmetries) {
  const Vec2 a(0.1, 0.7), b(0.30000000000000004, 2.1), c(0.2, 1.4);
  const int sign = orient2d(a, b, c);
  EXPECT_EQ(orient2d(b, c, a), sign);
  EXPECT_EQ(orient2d(c, a, b), sign);
  EXPECT_EQ(orient2d(b, a, c), -sign);
}

TEST(Orient3d, PositiveBelowThePlane) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, {0, 0, -1}), 1);
  EXPECT_EQ(orient3d(a, b, c, {0, 0, 1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {5, 7, 0}), 0);
}

TEST(Orient3d, IsExactNextToThePlane) {
  // The plane x = y; d is one unit in the last place beside it.
  const Vec3 a(12, 12, 0), b(24, 24, 0), c(24, 24, 24);
  const double x = 0.5, y = std::nextafter(0.5, 1.0);
  const int side = orient3d(a, b, c, {x, y, 7});
  EXPECT_NE(side, 0);
  EXPECT_EQ(orient3d(a, b, c, {y, x, 7}), -side);
  EXPECT_EQ(orient3d(a, b, c, {x, x, 7}), 0);
}

}  // namespace
}  // namespace plico
