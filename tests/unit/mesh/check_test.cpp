#include "plico/mesh/check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "plico/base/error.h"
#include "plico/mesh/repair.h"
#include "plico/mesh/self_intersections.h"

namespace plico {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

PolygonSoup tetrahedron() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (auto face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}})
    soup.add_face(face);
  return soup;
}

// The codes of all problems, without repetition.
std::vector<std::string> codes(const PolygonSoup& soup, const CheckOptions& options = {}) {
  std::vector<std::string> list;
  for (const Problem& problem : check_mesh(soup, options).problems)
    if (std::find(list.begin(), list.end(), problem.code) == list.end()) list.push_back(problem.code);
  return list;
}

TEST(Check, ATetrahedronIsFine) { EXPECT_THAT(codes(tetrahedron()), IsEmpty()); }

TEST(Check, NothingIsAnError) { EXPECT_THAT(codes({}), ElementsAre("mesh/empty")); }

TEST(Check, IndexOutOfRangeAndNegative) {
  PolygonSoup soup = tetrahedron();
  soup.add_face({0, 1, 4});
  soup.add_face({0, 1, -1});
  const CheckReport report = check_mesh(soup);
  ASSERT_EQ(report.problems.size(), 2u);
  EXPECT_EQ(report.problems[0].message, "face 4 uses vertex 4, must be in [0, 3]");
  EXPECT_EQ(report.problems[1].message, "face 5 uses vertex -1, must be in [0, 3]");
  EXPECT_THAT(report.problems[1].faces, ElementsAre(5));
}

TEST(Check, CoordinatesThatAreNoNumbersOrHuge) {
  for (double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -2e30}) {
    PolygonSoup soup = tetrahedron();
    soup.points[3].y() = x;
    const CheckReport report = check_mesh(soup);
    EXPECT_EQ(report.count(Severity::Error), 1) << x;
    EXPECT_THAT(report.problems[0].vertices, ElementsAre(3));
  }
}

TEST(Check, FacesWithoutThreeDifferentCornersOrWithoutArea) {
  PolygonSoup soup = tetrahedron();
  soup.points.emplace_back(2, 0, 0);
  soup.add_face({0, 1});
  soup.add_face({2, 3, 2});
  soup.add_face({0, 1, 4});
  EXPECT_THAT(codes(soup), ElementsAre("mesh/face-size", "mesh/repeated-vertex", "mesh/degenerate"));
}

TEST(Check, ASliverIsNotDegenerate) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}};
  soup.add_face({0, 1, 2});
  EXPECT_TRUE(check_mesh(soup).usable());
}

TEST(Check, EveryPlantedTopologicalDefectIsNamed) {
  PolygonSoup duplicate = tetrahedron(), fin = tetrahedron(), turned = tetrahedron();
  duplicate.add_face({1, 2, 0});
  EXPECT_THAT(codes(duplicate), ElementsAre("mesh/duplicate-face"));
  fin.points.emplace_back(1, 1, 1);
  fin.add_face({0, 1, 4});
  EXPECT_EQ(check_mesh(fin).problems[0].message, "edge 0-1 has 3 faces, at most 2 can unfold");
  EXPECT_THAT(check_mesh(fin).problems[0].faces, ElementsAre(0, 1, 4));
  std::reverse(turned.corners.begin(), turned.corners.begin() + 3);
  EXPECT_EQ(check_mesh(turned).count(Severity::Error), 3);
  EXPECT_THAT(codes(turned), ElementsAre("mesh/orientation"));
}

TEST(Check, TwoSolidsAtOneVertexAreABowTie) {
  PolygonSoup soup = tetrahedron();
  for (int v = 1; v < 4; ++v) soup.points.push_back(-soup.points[static_cast<std::size_t>(v)]);
  soup.add_face({0, 4, 5});
  soup.add_face({0, 6, 4});
  soup.add_face({4, 6, 5});
  soup.add_face({0, 5, 6});
  const CheckReport report = check_mesh(soup);
  ASSERT_EQ(report.count(Severity::Error), 1);
  EXPECT_EQ(report.problems[0].message, "the faces around vertex 0 make 2 fans, must make one");
  EXPECT_EQ(Mesh(repair(soup).soup).num_vertices(), 8);
}

TEST(Check, PolygonsMustBeFlatAndSimple) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-7}, {0, 1, 0}};
  soup.add_face({0, 1, 2, 3});
  EXPECT_THAT(codes(soup), ElementsAre("mesh/open"));
  EXPECT_THAT(codes(soup, {.planarity = 1e-9}), ElementsAre("mesh/not-planar", "mesh/open"));
  soup.points[2].z() = 0.1;
  EXPECT_THAT(codes(soup), ElementsAre("mesh/not-planar", "mesh/open"));
  soup.points = {{0, 0, 0}, {3, 1, 0}, {3, 0, 0}, {0, 2, 0}};
  EXPECT_THAT(codes(soup), ElementsAre("mesh/not-simple", "mesh/open"));
}

TEST(Check, WarningsAndNotesDoNotStopTheMesh) {
  PolygonSoup soup = tetrahedron();
  for (int f = 0; f < 4; ++f)
    std::swap(soup.corners[static_cast<std::size_t>(3 * f)], soup.corners[static_cast<std::size_t>(3 * f + 1)]);
  soup.points.emplace_back(9, 9, 9);
  EXPECT_THAT(codes(soup), ElementsAre("mesh/inside-out", "mesh/unused-vertex"));
  EXPECT_EQ(require_mesh(soup).num_faces(), 4);
  EXPECT_THAT(codes(tetrahedron(), {.max_faces = 3}), ElementsAre("mesh/too-many-faces"));
}

TEST(Check, RequireMeshThrowsTheFirstError) {
  PolygonSoup soup = tetrahedron();
  soup.add_face({0, 1, 1});
  try {
    require_mesh(soup);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.code(), "mesh/repeated-vertex");
    EXPECT_STREQ(error.what(), "face 4 uses vertex 1 twice (0 1 1)");
    EXPECT_THAT(error.where(), HasSubstr("near 0 0 0"));
    EXPECT_EQ(error.suggestion(), "plico check --repair");
  }
}

PolygonSoup two_triangles(std::vector<Vec3> points, std::initializer_list<int> second) {
  PolygonSoup soup;
  soup.points = std::move(points);
  soup.add_face({0, 1, 2});
  soup.add_face(second);
  return soup;
}

TEST(SelfIntersections, SharedVerticesAndEdgesDoNotCount) {
  const std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {-1, -1, 0}, {-1, -2, 0}};
  EXPECT_THAT(self_intersections(two_triangles(points, {1, 3, 2})), IsEmpty());
  EXPECT_THAT(self_intersections(two_triangles(points, {0, 4, 5})), IsEmpty());
  // A vertex given twice is the same place.
  EXPECT_THAT(self_intersections(
                  two_triangles({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {3, 4, 5})),
              IsEmpty());
}

TEST(SelfIntersections, CrossingTouchingAndLyingOnEachOther) {
  const auto pair = ElementsAre(Pair(0, 1));
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {0.5, 0.5, -1}, {0.6, 0.5, -1}, {0.5, 0.5, 1}}, {3, 4, 5})),
              pair);
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {0.5, 0.5, 0}, {0.6, 0.5, 1}, {0.5, 0.5, 1}}, {3, 4, 5})),
              pair);
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {0.5, 0.5, 0}, {0.6, 0.5, 0}, {0.5, 0.6, 0}}, {3, 4, 5})),
              pair);
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {0.5, 0.5, 1e-300}, {0.6, 0.5, 1}, {0.5, 0.5, 1}}, {3, 4, 5})),
              IsEmpty());
  // From a shared corner through the inside, and folded flat onto the neighbour across a shared edge.
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {1, 1, -1}, {1, 1, 1}}, {0, 3, 4})), pair);
  EXPECT_THAT(self_intersections(two_triangles({a, b, c, {1, 1, 0}}, {1, 0, 3})), pair);
}

TEST(Repair, SaysNothingAboutASoundMesh) {
  const Repaired repaired = repair(tetrahedron());
  EXPECT_THAT(repaired.done, IsEmpty());
  EXPECT_EQ(repaired.soup.corners, tetrahedron().corners);
}

TEST(Repair, TriangleSoupBecomesASolid) {
  PolygonSoup loose;
  const PolygonSoup solid = tetrahedron();
  for (int f = 0; f < 4; ++f) {
    const auto face = solid.face(f);
    for (int v : face) loose.points.push_back(solid.points[static_cast<std::size_t>(v)]);
    f == 2 ? loose.add_face({3 * f + 1, 3 * f, 3 * f + 2}) : loose.add_face({3 * f, 3 * f + 1, 3 * f + 2});
  }
  const Repaired repaired = repair(loose);
  EXPECT_THAT(repaired.done,
              ElementsAre("joined 8 vertices to others with equal coordinates",
                          "turned over 1 face to agree with the neighbours", "dropped 8 vertices without faces"));
  EXPECT_THAT(codes(repaired.soup), IsEmpty());
}

TEST(Repair, SafelyOnlyWhatChangesNoShape) {
  const RepairOptions safe{.level = RepairLevel::Safe};
  PolygonSoup fin = tetrahedron();  // three faces at an edge: not for us to decide
  fin.points.emplace_back(1, 1, -1);
  fin.add_face({0, 1, 4});
  EXPECT_THAT(repair(fin, safe).done, IsEmpty());
  EXPECT_EQ(repair(fin, safe).soup.corners, fin.corners);
  EXPECT_TRUE(check_mesh(repair(fin).soup).usable());

  PolygonSoup hole = tetrahedron();  // a coordinate that is no number: without its faces a hole would be left
  hole.points[3].x() = std::nan("");
  EXPECT_THAT(repair(hole, safe).done, IsEmpty());
}

TEST(Repair, SafelyJoinsCornersOnlyWhenFacesCloseUp) {
  const RepairOptions safe{.level = RepairLevel::Safe};
  const PolygonSoup one = tetrahedron();
  PolygonSoup loose;
  for (int f = 0; f < 4; ++f) {
    for (int v : one.face(f)) loose.points.push_back(one.points[v]);
    loose.add_face({3 * f, 3 * f + 1, 3 * f + 2});
  }
  EXPECT_EQ(repair(loose, safe).soup.num_points(), 4);
  // Two solids that share an edge stay two: joined, four faces would meet there.
  PolygonSoup two = one;
  for (const Vec3& p : one.points) two.points.emplace_back(p.x(), -p.y(), -p.z());
  for (int f = 0; f < 4; ++f) {
    const auto face = one.face(f);
    two.add_face({face[0] + 4, face[1] + 4, face[2] + 4});
  }
  EXPECT_EQ(repair(two, safe).soup.num_points(), 8);
  EXPECT_THAT(repair(two, safe).done, IsEmpty());
}

TEST(Repair, FacesThinnerThanSinglePrecisionHaveNoArea) {
  PolygonSoup soup = tetrahedron();
  soup.points.emplace_back(0.5, 1e-8, -1e-9);
  soup.add_face({1, 0, 4});
  const Repaired repaired = repair(soup, {.level = RepairLevel::Safe});
  EXPECT_THAT(repaired.done, ElementsAre("removed 1 face without area", "dropped 1 vertex without faces"));
  EXPECT_TRUE(check_mesh(repaired.soup).usable());
}

TEST(Repair, AOneSidedSurfaceIsCutOpen) {
  PolygonSoup band;
  for (int i = 0; i < 5; ++i) {
    const double t = 2 * kPi * i / 5, half = t / 2;
    for (double s : {-0.3, 0.3})
      band.points.emplace_back((1 + s * std::cos(half)) * std::cos(t), (1 + s * std::cos(half)) * std::sin(t),
                               s * std::sin(half));
  }
  for (int i = 0; i < 5; ++i) {
    const int a = 2 * i, b = a + 1, c = i < 4 ? a + 2 : 1, d = i < 4 ? a + 3 : 0;
    band.add_face({a, c, b});
    band.add_face({b, c, d});
  }
  EXPECT_FALSE(check_mesh(band).usable());
  const Repaired repaired = repair(band);
  EXPECT_TRUE(check_mesh(repaired.soup).usable());
  EXPECT_EQ(repaired.soup.num_faces(), 10);
  EXPECT_EQ(repaired.soup.num_points(), 12);
}

}  // namespace
}  // namespace plico
