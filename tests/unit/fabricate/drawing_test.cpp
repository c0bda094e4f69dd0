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
  const std::vector<Drawing> pages = draw(layout);
  for (const Stroke& stroke : pages.front().strokes)
    if (stroke.layer == Layer::Cut) areas.push_back(std::abs(signed_area(stroke.points)));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_LT(areas[0], areas[1]);
}

bool says(const Drawing& page, const std::string& text) {
  return std::ranges::any_of(page.texts, [&](const Text& line) { return line.text == text; });
}

TEST(Drawing, TitlesAreWhole) {
  const PageLayout layout = cube_page();
  EXPECT_TRUE(says(draw(layout, {.title = "cube"}).front(), "cube · 40 × 40 × 40 mm · page 1 of 1"));
  const std::string dinosaur = "lowpoly-dino-650-of-a-long-name-and-more-of-it";
  const Drawing page = draw(layout, {.title = dinosaur}).front();
  EXPECT_TRUE(says(page, dinosaur));
  EXPECT_TRUE(says(page, "40 × 40 × 40 mm · page 1 of 1"));
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

TEST(Drawing, TheInsideIsMirroredItsMountainsAreValleysAndItsLettersStayLetters) {
  const Drawing outside = draw(cube_page()).front(),
                inside = draw(cube_page(), {.title = "", .side = PaperSide::Inside}).front();
  EXPECT_EQ(strokes_in(inside, Layer::Valley), strokes_in(outside, Layer::Mountain));
  const auto cut = [](const Drawing& d) { return *std::ranges::find(d.strokes, Layer::Cut, &Stroke::layer); };
  EXPECT_NEAR(signed_area(cut(inside).points), -signed_area(cut(outside).points), 1e-9);
  for (const Text& text : inside.texts) {
    EXPECT_GT(text.angle, -kPi / 2 - 1e-6);
    EXPECT_LE(text.angle, kPi / 2 + 1e-6);
  }
  const std::vector<Drawing> both = draw(cube_page(), {.title = "", .side = PaperSide::Both});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_TRUE(both[0].texts.empty());
  EXPECT_EQ(strokes_in(both[0], Layer::Cut), 1);
  EXPECT_EQ(strokes_in(both[1], Layer::Cut), 0);
  EXPECT_EQ(both[1].texts.size(), outside.texts.size());
}

TEST(Drawing, TheShadowOfATabLiesOnThePanelThatItIsGluedUnder) {
  const PageLayout layout = cube_page();
  const Drawing with = draw(layout, {.title = "", .shadow_tabs = true}).front(), without = draw(layout).front();
  ASSERT_EQ(with.strokes.size(), without.strokes.size() + 7);
  int on_a_panel = 0;
  for (const Stroke& stroke : with.strokes) {
    if (stroke.layer != Layer::Mark || stroke.closed || stroke.points.size() != 4) continue;
    for (const PlacedPanel& panel : layout.parts[0].panels) {
      Eigen::AlignedBox2d box;  // the cube's net stands upright
      for (const Vec2& p : panel.corners) box.extend(p);
      box.extend(box.min() - Vec2::Constant(1e-6)), box.extend(box.max() + Vec2::Constant(1e-6));
      on_a_panel += std::ranges::all_of(stroke.points, [&](const Vec2& p) { return box.contains(p); });
    }
  }
  EXPECT_EQ(on_a_panel, 7);
}

}  // namespace
}  // namespace plico
