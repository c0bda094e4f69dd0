#include "plico/io/page/drawing.h"

#include <gtest/gtest.h>

#include "fabricate_samples.h"
#include "plico/base/error.h"
#include "plico/fabricate/fabricate.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

PageLayout cube_page() {
  const Mesh mesh = samples::cube();
  LayoutOptions options;
  options.size.longest = 40;
  return lay_out_pages(samples::net_of(mesh), folded_shape(mesh), options).layout;
}

int strokes_in(const Drawing& drawing, Layer layer) {
  return static_cast<int>(std::ranges::count(drawing.strokes, layer, &Stroke::layer));
}

TEST(Drawing, APerforatedFoldIsARowOfCutsWithPaperBetweenThemAndAtItsEnds) {
  const Drawing page = draw(cube_page(), {.title = "", .perforation = {3, 1}}).front();
  // Folds and bases of tabs are 40 mm: ten cuts of 3 mm, 9 gaps of 1 mm, half a millimetre at each end. Tabs that are
  // glued to a corner have full bases.
  EXPECT_EQ(strokes_in(page, Layer::Mountain), 12 * 10);
  const Stroke* last = nullptr;
  for (const Stroke& stroke : page.strokes) {
    if (stroke.layer != Layer::Mountain || page.pens[stroke.pen].fill) continue;
    EXPECT_TRUE(page.pens[stroke.pen].dash.empty());
    EXPECT_NEAR((stroke.points[1] - stroke.points[0]).norm(), 3, 1e-9);
    const double gap = last ? (stroke.points[0] - last->points[1]).norm() : 1;
    EXPECT_GT(gap, std::sqrt(0.5) - 1e-9);  // rows that meet at a right angle keep half a gap each
    last = &stroke;
  }
  EXPECT_THROW(draw(cube_page(), {.title = "", .perforation = {3, 0}}), InvalidOption);
}

TEST(Drawing, WhatLiesInsideIsCutBeforeWhatIsAroundIt) {
  PageLayout layout = cube_page();
  const Vec2 at = layout.parts[0].panels[0].corners[0];
  layout.parts[0].outlines.push_back({at, at + Vec2(0, 1), at + Vec2(1, 0)});  // a hole, after the outer one
  std::vector<double> areas;
  for (const Stroke& stroke : draw(layout).front().strokes)
    if (stroke.layer == Layer::Cut) areas.push_back(std::abs(signed_area(stroke.points)));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_LT(areas[0], areas[1]);
}

TEST(Drawing, LettersBecomeOutlinesOrAreLeftOut) {
  const Drawing plain = draw(cube_page()).front(),
                outlined = draw(cube_page(), {.title = "", .text = TextForm::Outlines}).front();
  EXPECT_GT(plain.texts.size(), 14U);
  EXPECT_EQ(strokes_in(plain, Layer::Text), 0);
  EXPECT_TRUE(outlined.texts.empty());
  EXPECT_GE(strokes_in(outlined, Layer::Text), 14);
  const Drawing none = draw(cube_page(), {.title = "", .text = TextForm::None}).front();
  EXPECT_TRUE(none.texts.empty());
  EXPECT_EQ(strokes_in(none, Layer::Text), 0);
}

}  // namespace
}  // namespace plico
