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

}  // namespace
}  // namespace plico
