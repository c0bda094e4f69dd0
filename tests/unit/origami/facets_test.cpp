#include "plico/origami/facets.h"

#include <gtest/gtest.h>

#include "plico/geom/polygon.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

TEST(Facets, AreTrianglesThatCoverThePanels) {
  const CreasePattern sheet = miura({.columns = 3, .rows = 2});
  const Facets facets = cut_into_facets(sheet);
  EXPECT_EQ(facets.sheet.num_faces(), 2 * sheet.num_faces());
  EXPECT_EQ(facets.sheet.num_edges(), sheet.num_edges() + sheet.num_faces());
  std::vector<double> area(sheet.num_faces(), 0);
  for (int f = 0; f < facets.sheet.num_faces(); ++f) {
    const double part = signed_area(polygon(facets.sheet, f));
    EXPECT_GT(part, 0);
    area[facets.panel[f]] += part;
  }
  for (int f = 0; f < sheet.num_faces(); ++f) EXPECT_NEAR(area[f], signed_area(polygon(sheet, f)), 1e-12);
}

TEST(Facets, AreCutByTheShorterDiagonal) {
  CreasePattern kite;
  kite.vertices = {{0, 0}, {1, -0.5}, {3, 0}, {1, 0.5}};
  kite.faces = {{0, 1, 2, 3}};
  for (int i = 0; i < 4; ++i) kite.edges.push_back({i, (i + 1) % 4, Assignment::Boundary});
  const Facets facets = cut_into_facets(kite);
  ASSERT_EQ(facets.sheet.num_edges(), 5);
  const Crease& cut = facets.sheet.edges[facets.first_cut];
  EXPECT_EQ(std::min(cut.a, cut.b), 1);
  EXPECT_EQ(std::max(cut.a, cut.b), 3);
  EXPECT_EQ(cut.assignment, Assignment::Flat);
  EXPECT_EQ(cut.fold_angle, 0);
}

TEST(Facets, AreCutByTheLongerDiagonalWhenAsked) {
  CreasePattern kite;
  kite.vertices = {{0, 0}, {1, -0.5}, {3, 0}, {1, 0.5}};
  kite.faces = {{0, 1, 2, 3}};
  for (int i = 0; i < 4; ++i) kite.edges.push_back({i, (i + 1) % 4, Assignment::Boundary});
  const Facets facets = cut_into_facets(kite, CutChoice::Long);
  ASSERT_EQ(facets.sheet.num_edges(), 5);
  const Crease& cut = facets.sheet.edges[facets.first_cut];
  EXPECT_EQ(std::min(cut.a, cut.b), 0);
  EXPECT_EQ(std::max(cut.a, cut.b), 2);
}

TEST(Facets, DrawnOnesDependOnTheSeedAndCoverThePanels) {
  const CreasePattern sheet = miura({.columns = 6, .rows = 6});
  const Facets first = cut_into_facets(sheet, CutChoice::Drawn, 1), other = cut_into_facets(sheet, CutChoice::Drawn, 2);
  EXPECT_EQ(first.sheet.faces, cut_into_facets(sheet, CutChoice::Drawn, 1).sheet.faces);
  EXPECT_NE(first.sheet.faces, other.sheet.faces);
  double area = 0;
  for (int f = 0; f < first.sheet.num_faces(); ++f) {
    const double part = signed_area(polygon(first.sheet, f));
    EXPECT_GT(part, 0);
    area += part;
  }
  double whole = 0;
  for (int f = 0; f < sheet.num_faces(); ++f) whole += signed_area(polygon(sheet, f));
  EXPECT_NEAR(area, whole, 1e-12);
}

TEST(Facets, OfAPanelWithADentStayInsideIt) {
  CreasePattern arrow;
  arrow.vertices = {{0, 0}, {2, 1}, {0, 2}, {1, 1}};  // the shorter diagonal, 1-3, is inside; 0-2 is not
  arrow.faces = {{0, 1, 2, 3}};
  for (int i = 0; i < 4; ++i) arrow.edges.push_back({i, (i + 1) % 4, Assignment::Boundary});
  const Facets facets = cut_into_facets(arrow);
  ASSERT_EQ(facets.sheet.num_faces(), 2);
  for (int f : {0, 1}) EXPECT_NEAR(signed_area(polygon(facets.sheet, f)), 0.5, 1e-12);
}

TEST(Facets, TrianglesAreNotCut) {
  const CreasePattern sheet = yoshimura({.columns = 2, .rows = 2});
  EXPECT_EQ(cut_into_facets(sheet).sheet.num_edges(), sheet.num_edges());
}

// A crease across a square, drawn as a curve with five straight ones.
TEST(Facets, CutsEndAtTheVerticesOfACurveOnBothSides) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}, {2, 6}, {4, 6.5}, {6, 6.5}, {8, 6}, {10, 5}};
  const auto border = [&](int a, int b) { sheet.edges.push_back({a, b, Assignment::Boundary, 0}); };
  for (const auto& [a, b] : {std::pair(0, 1), {1, 9}, {9, 2}, {2, 3}, {3, 4}, {4, 0}}) border(a, b);
  for (int v = 4; v < 9; ++v) sheet.edges.push_back({v, v + 1, Assignment::Valley, kPi});
  sheet.faces = {{0, 1, 9, 8, 7, 6, 5, 4}, {2, 3, 4, 5, 6, 7, 8, 9}};
  const Facets facets = cut_into_facets(sheet);
  std::vector<int> cuts(sheet.vertices.size(), 0);
  for (int e = facets.first_cut; e < facets.sheet.num_edges(); ++e) {
    ++cuts[facets.sheet.edges[e].a];
    ++cuts[facets.sheet.edges[e].b];
  }
  for (int v = 5; v <= 8; ++v) EXPECT_GE(cuts[v], 2) << v;
}

}  // namespace
}  // namespace plico
