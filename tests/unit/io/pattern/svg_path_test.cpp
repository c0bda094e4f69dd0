#include "plico/io/pattern/svg_path.h"

#include <gmock/gmock.h>

#include <cmath>

namespace plico {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

double farthest_from_circle(const std::vector<SvgStroke>& strokes, const Vec2& centre, double radius) {
  double worst = 0;
  for (const SvgStroke& stroke : strokes)
    for (const Vec2& p : flatten(stroke, 1e-6 * radius))
      worst = std::max(worst, std::abs((p - centre).norm() - radius));
  return worst;
}

TEST(SvgPath, RelativeAndAbsoluteCommandsDrawTheSame) {
  const SvgPath big = parse_path("M1 2 L4 2 H6 V5 C6 6 5 7 4 7 S2 6 2 5 Q2 4 3 4 T4 3 A1 1 0 0 1 5 2 Z");
  const SvgPath small = parse_path("m1,2l3,0h2v3c0,1-1,2-2,2s-2-1-2-2q0-1 1-1t1-1a1 1 0 011-1z");
  ASSERT_THAT(big.error, IsEmpty());
  ASSERT_THAT(small.error, IsEmpty());
  ASSERT_EQ(big.strokes.size(), small.strokes.size());
  for (std::size_t i = 0; i < big.strokes.size(); ++i) {
    EXPECT_EQ(big.strokes[i].b, small.strokes[i].b) << i;
    EXPECT_NEAR((big.strokes[i].c - small.strokes[i].c).norm(), 0, 1e-12) << i;
    EXPECT_NEAR((big.strokes[i].d - small.strokes[i].d).norm(), 0, 1e-12) << i;
  }
}

TEST(SvgPath, SmoothCurvesGoOnWithoutAKink) {
  const std::vector<SvgStroke> strokes = parse_path("M0 0C0 1 1 2 2 2S4 1 4 0").strokes;
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[1].c - strokes[1].a, strokes[0].b - strokes[0].d);
}

TEST(SvgPath, ArcsLieOnTheirCircle) {
  for (const char* flags : {"0 0", "0 1", "1 0", "1 1"}) {
    const SvgPath path = parse_path(std::string("M3 0A3 3 0 ") + flags + " 0 3");
    const Vec2 centre =
        flags[0] == '1' ? (flags[2] == '1' ? Vec2(3, 3) : Vec2(0, 0)) : (flags[2] == '1' ? Vec2(0, 0) : Vec2(3, 3));
    EXPECT_LT(farthest_from_circle(path.strokes, centre, 3), 1e-3) << flags;
    EXPECT_EQ(path.strokes.back().b, Vec2(0, 3));
  }
  EXPECT_LT(farthest_from_circle(ellipse_strokes({1, 1}, 2, 2), {1, 1}, 2), 2.0 / 3000);
  EXPECT_LT(farthest_from_circle(parse_path("M0 0A1 1 0 0 0 8 0").strokes, {4, 0}, 4), 4.0 / 3000);  // too small radii
}

TEST(SvgPath, FlatCurvesAreOneLineAndOthersStayWithinTheTolerance) {
  EXPECT_EQ(flatten(parse_path("M0 0C1 0 2 0 3 0").strokes[0], 1e-9).size(), 2U);
  const SvgStroke quarter = ellipse_strokes({0, 0}, 1, 1)[0];
  for (double tolerance : {0.1, 0.01, 0.001}) {
    const std::vector<Vec2> chain = flatten(quarter, tolerance);
    for (std::size_t i = 1; i < chain.size(); ++i)
      EXPECT_LT(1 - ((chain[i - 1] + chain[i]) / 2).norm(), tolerance + 1.0 / 3000);
  }
}

TEST(SvgPath, RoundCornersAreCutToTheRectangle) {
  EXPECT_EQ(rectangle_strokes({0, 0}, {4, 2}, 0, 0).size(), 4U);
  EXPECT_EQ(rectangle_strokes({0, 0}, {4, 2}, 1, 0.5).size(), 8U);
  EXPECT_EQ(rectangle_strokes({0, 0}, {4, 2}, 9, 9).size(), 4U);  // an ellipse
}

TEST(SvgPath, ErrorsNameTheByte) {
  EXPECT_THAT(parse_path("M0 0L1").error, HasSubstr("lacks a number after L at byte 6"));
  EXPECT_THAT(parse_path("M0 0Z1 1").error, HasSubstr("has '1', where a command must stand, at byte 5"));
  EXPECT_THAT(parse_path("M0 0A1 1 0 2 0 3 3").error, HasSubstr("lacks a flag"));
  EXPECT_THAT(parse_path("").error, IsEmpty());
}

}  // namespace
}  // namespace plico
