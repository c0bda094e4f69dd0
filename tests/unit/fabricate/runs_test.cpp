#include "plico/fabricate/runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "plico/base/error.h"
#include "plico/verify/page_layout.h"

namespace plico {
namespace {

// Ten squares that turn left three times, so that the last ones lie over the first, hinges first among the edges.
CreasePattern winding_strip() {
  CreasePattern strip;
  strip.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  strip.faces = {{0, 1, 2, 3}};
  std::vector<Crease> borders;
  int heading = 0;
  for (int p = 0; p + 1 < 10; ++p) {
    heading = (heading + (p == 2 || p == 4 || p == 6)) % 4;
    const std::vector<int> face = strip.faces.back();
    const int a = face[(heading + 1) % 4], b = face[(heading + 2) % 4];
    const Vec2 step = heading == 0 ? Vec2(1, 0) : heading == 1 ? Vec2(0, 1) : heading == 2 ? Vec2(-1, 0) : Vec2(0, -1);
    std::vector<int> next(4, -1);
    next[heading] = a;
    next[(heading + 3) % 4] = b;
    for (int corner : {(heading + 1) % 4, (heading + 2) % 4}) {
      next[corner] = strip.num_vertices();
      strip.vertices.push_back(strip.vertices[face[corner]] + step);
    }
    strip.edges.push_back({a, b, p % 2 ? Assignment::Mountain : Assignment::Flat, p % 2 ? -kPi / 2 : 0});
    strip.faces.push_back(next);
  }
  std::set<std::pair<int, int>> seen;
  for (const Crease& hinge : strip.edges) seen.insert(std::minmax(hinge.a, hinge.b));
  for (const std::vector<int>& face : strip.faces)
    for (int i = 0; i < 4; ++i)
      if (seen.insert(std::minmax(face[i], face[(i + 1) % 4])).second)
        borders.push_back({face[i], face[(i + 1) % 4], Assignment::Boundary, 0});
  strip.edges.insert(strip.edges.end(), borders.begin(), borders.end());
  return strip;
}

RunOptions with_side(double side) {
  RunOptions options;
  options.side = side;
  options.trim = side / 10;
  return options;
}

TEST(Runs, AreCutWhereTheStripLiesOverItself) {
  const PageLayout layout = lay_out_runs(winding_strip(), with_side(25));
  ASSERT_EQ(layout.parts.size(), 2u);
  EXPECT_EQ(layout.parts[0].panels.size() + layout.parts[1].panels.size(), 10u);
  const LayoutVerdict verdict = verify_layout(layout);
  EXPECT_TRUE(verdict.sound()) << (verdict.problems.empty() ? "" : verdict.problems.front());
}

TEST(Runs, NumberTheirPanelsAndNameAJointOnBothSides) {
  const PageLayout layout = lay_out_runs(winding_strip(), with_side(25));
  std::multiset<std::string> texts;
  for (const PlacedPart& part : layout.parts)
    for (const Label& label : part.labels) texts.insert(label.text);
  for (int panel = 0; panel < 10; ++panel) EXPECT_EQ(texts.count(std::to_string(panel)), 1u) << panel;
  const std::size_t first = layout.parts[0].panels.size();
  EXPECT_EQ(texts.count("J" + std::to_string(first - 1)), 2u);
  EXPECT_EQ(texts.size(), 12u);
}

TEST(Runs, HaveSquaresOfTheWantedSideAndTrimmedPanels) {
  const PageLayout layout = lay_out_runs(winding_strip(), with_side(80));
  EXPECT_GT(layout.parts.size(), 2u) << "two squares of 80 mm fit side by side on A4";
  for (const PlacedPart& part : layout.parts) {
    for (const PlacedPanel& panel : part.panels)
      for (int i = 0; i < 4; ++i) EXPECT_NEAR((panel.corners[i] - panel.corners[(i + 1) % 4]).norm(), 80, 1e-9);
    for (const Mark& mark : part.marks) EXPECT_NEAR((mark.points[0] - mark.points[1]).norm(), 64, 1e-9);
  }
  EXPECT_TRUE(verify_layout(layout).sound());
}

TEST(Runs, RefuseASquareThatNoPageHolds) {
  EXPECT_THROW(lay_out_runs(winding_strip(), with_side(200)), InvalidOption);
  EXPECT_THROW(lay_out_runs(winding_strip(), with_side(0)), InvalidOption);
}

}  // namespace
}  // namespace plico
