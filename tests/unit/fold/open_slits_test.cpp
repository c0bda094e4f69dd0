#include "plico/fold/open_slits.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "plico/fold/planar_faces.h"

namespace plico {
namespace {

// A grid of squares, its lines flat but for those in `cuts`, each from x, y to the right.
CreasePattern grid(int columns, int rows, const std::vector<std::pair<int, int>>& cuts) {
  CreasePattern sheet;
  const auto at = [&](int x, int y) { return y * (columns + 1) + x; };
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) {
      sheet.vertices.emplace_back(x, y);
      const bool cut = std::find(cuts.begin(), cuts.end(), std::pair(x, y)) != cuts.end();
      const bool side = y == 0 || y == rows, end = x == 0 || x == columns;
      if (x < columns)
        sheet.edges.push_back({at(x, y), at(x + 1, y),
                               cut    ? Assignment::Cut
                               : side ? Assignment::Boundary
                                      : Assignment::Flat});
      if (y < rows) sheet.edges.push_back({at(x, y), at(x, y + 1), end ? Assignment::Boundary : Assignment::Flat});
    }
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

// Panels, areas and hinges stay; no cut has paper on both sides.
void expect_same_paper(const CreasePattern& sheet, const CreasePattern& open) {
  ASSERT_EQ(open.num_faces(), sheet.num_faces());
  const std::vector<EdgeSides> before = edge_sides(sheet), after = edge_sides(open);
  for (int e = 0; e < open.num_edges(); ++e) {
    EXPECT_TRUE(after[e].left >= 0 || after[e].right >= 0) << e;
    const bool joins = after[e].left >= 0 && after[e].right >= 0;
    EXPECT_FALSE(joins && open.edges[e].assignment == Assignment::Cut) << e;
    if (e >= sheet.num_edges() || !is_hinge(sheet.edges[e], before[e])) continue;
    EXPECT_EQ(after[e].left, before[e].left);
    EXPECT_EQ(after[e].right, before[e].right);
  }
}

TEST(OpenSlits, ASheetWithoutOnesStaysAsItIs) {
  const CreasePattern sheet = grid(2, 2, {}), open = open_slits(sheet);
  EXPECT_EQ(open.num_vertices(), sheet.num_vertices());
  EXPECT_EQ(open.num_edges(), sheet.num_edges());
  EXPECT_EQ(open.faces, sheet.faces);
}

TEST(OpenSlits, OneInsideTheSheetDoublesWhatIsBetweenItsEnds) {
  const CreasePattern sheet = grid(4, 2, {{1, 1}, {2, 1}}), open = open_slits(sheet);
  EXPECT_EQ(open.num_vertices(), sheet.num_vertices() + 1);
  EXPECT_EQ(open.num_edges(), sheet.num_edges() + 2);
  EXPECT_EQ(parts_of(open), std::vector<int>(8, 0));
  expect_same_paper(sheet, open);
}

TEST(OpenSlits, OneFromTheRimDoublesTheVertexThere) {
  const CreasePattern sheet = grid(2, 2, {{0, 1}}), open = open_slits(sheet);
  EXPECT_EQ(open.num_vertices(), sheet.num_vertices() + 1);
  expect_same_paper(sheet, open);
}

TEST(OpenSlits, OneThatHoldsTogetherAtBothEndsGetsAMiddle) {
  const CreasePattern sheet = grid(3, 2, {{1, 1}}), open = open_slits(sheet);
  EXPECT_EQ(open.num_vertices(), sheet.num_vertices() + 1);
  EXPECT_EQ(open.num_edges(), sheet.num_edges() + 2);
  expect_same_paper(sheet, open);
}

TEST(OpenSlits, OneAcrossMakesTwoSheets) {
  const CreasePattern sheet = grid(2, 2, {{0, 1}, {1, 1}}), open = open_slits(sheet);
  EXPECT_EQ(open.num_vertices(), sheet.num_vertices() + 3);
  const std::vector<int> part = parts_of(open);
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1);
  expect_same_paper(sheet, open);
}

}  // namespace
}  // namespace plico
