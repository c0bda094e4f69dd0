#include "plico/fold/panel_paint.h"

#include <gtest/gtest.h>

#include "plico/geom/polygon.h"

namespace plico {
namespace {

const Color kRed{1, 0, 0}, kBlue{0, 0, 1};

// A unit square as one face.
Mesh square() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.add_face({0, 1, 2, 3});
  return Mesh(soup);
}

PaintedTriangle triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Color& color) {
  return {{a, b, c}, {color, color, color}};
}

PanelPaint painted(const std::vector<PaintedTriangle>& triangles) {
  const Mesh mesh = square();
  return panel_paint(mesh, lay_flat(mesh, {std::vector<char>(mesh.num_edges(), 0)}), {triangles, {}});
}

TEST(PanelPaint, APanelOfOneColourIsOnePatch) {
  const PanelPaint paint =
      painted({triangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, kRed), triangle({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, kRed)});
  ASSERT_EQ(paint.panels.at(0).size(), 1U);
  EXPECT_EQ(paint.panels[0][0].corners.size(), 4U);
  EXPECT_EQ(paint.panels[0][0].color, kRed);
}

TEST(PanelPaint, APanelOfTwoColoursKeepsBothExactly) {
  const PanelPaint paint =
      painted({triangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, kRed), triangle({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, kBlue)});
  ASSERT_EQ(paint.panels.at(0).size(), 2U);
  for (const Patch& patch : paint.panels[0]) EXPECT_NEAR(signed_area(patch.corners), 0.5, 1e-12);
  const Color mean = panel_colors(paint).at(0);
  EXPECT_NEAR(mean[0], 0.5, 1e-9);
  EXPECT_NEAR(mean[2], 0.5, 1e-9);
}

TEST(PanelPaint, WhereThePaintLiesElsewhereEachPointHasTheLookOfTheNearest) {
  const double z = 0.05;  // the shape was simplified
  const PanelPaint paint = painted(
      {triangle({0, 0, z}, {0.5, 0, z}, {0.5, 1, z}, kRed), triangle({0, 0, z}, {0.5, 1, z}, {0, 1, z}, kRed),
       triangle({0.5, 0, z}, {1, 0, z}, {1, 1, z}, kBlue), triangle({0.5, 0, z}, {1, 1, z}, {0.5, 1, z}, kBlue)});
  const Patch& patch = paint.panels.at(0).at(0);
  ASSERT_GE(patch.picture, 0);
  EXPECT_EQ(color_at(paint.pictures[patch.picture], patch.uv_at({0.2, 0.7})), kRed);
  EXPECT_EQ(color_at(paint.pictures[patch.picture], patch.uv_at({0.8, 0.3})), kBlue);
}

TEST(PanelPaint, NoPaintGivesNone) { EXPECT_TRUE(painted({}).empty()); }

TEST(HexText, ReadsWhatItWrites) {
  EXPECT_EQ(hex_text({1, 0, 128 / 255.0}), "#ff0080");
  EXPECT_EQ(parse_hex("#ff0080"), (Color{1, 0, 128 / 255.0}));
  for (const char* wrong : {"", "ff0080", "#ff008", "#ff00800", "#gg0080"}) EXPECT_FALSE(parse_hex(wrong)) << wrong;
}

}  // namespace
}  // namespace plico
