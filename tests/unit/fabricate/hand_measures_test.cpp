#include "plico/fabricate/hand_measures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/fabricate/fabricate.h"
#include "plico/fabricate/net_sides.h"
#include "plico/shapes/named_shapes.h"

namespace plico {
namespace {

// A strip of n unit squares joined by folds, or by cuts where told.
Mesh strip(int n, double height) {
  PolygonSoup soup;
  for (int i = 0; i <= n; ++i)
    for (double y : {0.0, height}) soup.points.emplace_back(i, y, 0);
  for (int i = 0; i < n; ++i) soup.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return Mesh(soup);
}

Unfolding all_folded(const Mesh& mesh) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges()) forest.is_fold[e] = !mesh.is_boundary(e);
  return lay_flat(mesh, forest);
}

TEST(HandMeasures, AStripFillsItsHullAndIsWeakWhereShortFoldsCarryMoreThanThreePanels) {
  const Unfolding net = all_folded(strip(9, 1));
  const HandMeasures at4 = measure_for_hands(net, 4), at6 = measure_for_hands(net, 6);
  EXPECT_NEAR(at4.hull_area, 9 * 16, 1e-9);
  EXPECT_NEAR(at4.left_over(), 0, 1e-9);
  EXPECT_NEAR(at4.shortest_carrying, 4, 1e-12);
  EXPECT_EQ(at4.weak, 2);  // 4 | 5 and 5 | 4 panels
  EXPECT_EQ(at6.weak, 0);
  EXPECT_EQ(measure_for_hands(all_folded(strip(7, 1)), 4).weak, 0);  // no fold has four panels on both sides
}

TEST(HandMeasures, NoNetHasFewerWeakFoldsThanPartsOfTheShapeThatOnlyShortEdgesJoin) {
  const Unfolding net = all_folded(strip(9, 1));
  EXPECT_EQ(measure_for_hands(net, 6).least_weak, 0);
  EXPECT_EQ(measure_for_hands(net, 4).least_weak, 1);  // panels 0 and 8 share no piece within three steps
  EXPECT_EQ(measure_for_hands(all_folded(strip(7, 1)), 4).least_weak, 0);
}

TEST(HandMeasures, WhereWeakFoldsAreCutNoneIsLeft) {
  const Unfolding net = all_folded(strip(9, 1));
  const std::vector<char> weak = weak_folds(net, 4);
  const Unfolding cut = cut_folds(net, weak);
  EXPECT_EQ(std::count(weak.begin(), weak.end(), 1), 1);  // 4 | 5: five panels have no fold left that carries four
  EXPECT_EQ(cut.num_parts(), 2);
  EXPECT_EQ(measure_for_hands(cut, 4).weak, 0);
  EXPECT_EQ(weak_folds(net, 6), std::vector<char>(net.sheet.num_edges(), 0));
}

// Panels in a row, 8 high, but for one waist of 4 in the middle.
Mesh strip_with_waist(int n) {
  PolygonSoup soup;
  for (int i = 0; i <= n; ++i)
    for (double y : {0.0, i == n / 2 ? 4.0 : 8.0}) soup.points.emplace_back(4 * i, y, 0);
  for (int i = 0; i < n; ++i) soup.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return Mesh(soup);
}

TEST(HandMeasures, FewWeakFoldsAreCutWherePartsMayBeSplit) {
  const auto parts = [](int panels, bool split) {
    LayoutOptions options;
    options.weak_folds = WeakFolds::CutFew;
    options.split = split;
    return lay_out_pages(all_folded(strip_with_waist(panels)), {}, options).report.parts;
  };
  EXPECT_EQ(parts(20, true), 2);
  EXPECT_EQ(parts(20, false), 1);
  EXPECT_EQ(parts(10, true), 1);  // one cut for ten panels is much
}

TEST(HandMeasures, NeedlesHangByTheirShortSideOnlyIfALongOneCouldFold) {
  EXPECT_EQ(measure_for_hands(all_folded(strip(3, 0.2)), 10).needles, 0);  // long sides are the mesh's boundary
  const Mesh two = [] {
    PolygonSoup soup;
    soup.points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}, {5, 0.5, 0}, {4, -1, 0}, {0, -1, 0}};
    soup.add_face({0, 1, 2, 3});
    soup.add_face({1, 4, 2});
    soup.add_face({0, 6, 5, 1});
    return Mesh(soup);
  }();
  FoldForest forest{std::vector<char>(two.num_edges(), 0)};
  for (EdgeId e : two.edges())
    if (!two.is_boundary(e) && std::abs(two.point(two.from(two.halfedge(e))).x() - 4) < 1e-9 &&
        std::abs(two.point(two.to(two.halfedge(e))).x() - 4) < 1e-9)
      forest.is_fold[e] = 1;
  EXPECT_EQ(measure_for_hands(lay_flat(two, forest), 10).needles, 1);  // the loose one hangs by nothing
  EXPECT_EQ(measure_for_hands(all_folded(two), 10).needles, 0);
}

}  // namespace
}  // namespace plico
