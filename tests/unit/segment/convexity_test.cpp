#include "plico/segment/convexity.h"

#include <gtest/gtest.h>

#include <set>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/segment/hull_depth.h"
#include "plico/segment/patch_cut.h"
#include "plico/segment/ridges.h"
#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

int count_parts(const std::vector<int>& labels) {
  return static_cast<int>(std::set<int>(labels.begin(), labels.end()).size());
}

std::vector<int> whole(const Mesh& mesh) {
  std::vector<int> faces;
  for (FaceId f : mesh.faces()) faces.push_back(f);
  return faces;
}

// The unit cube, its top pushed down to a point at this height.
Mesh dented_cube(double bottom) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},       {0, 0, 1},
                 {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {.5, .5, bottom}};
  soup.add_face({0, 3, 2, 1});
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    soup.add_face({i, j, 4 + j, 4 + i});
    soup.add_face({4 + i, 4 + j, 8});
  }
  return Mesh(std::move(soup));
}

TEST(HullDepth, IsTheDistanceToTheNearestFacetOfTheHull) {
  const Mesh mesh = dented_cube(0.7);
  const PatchVertices patch = hull_depths(mesh, whole(mesh));
  EXPECT_NEAR(patch.depth[8], 0.3, 1e-15);
  EXPECT_NEAR(patch.depth[0], 0, 1e-15);
  EXPECT_FALSE(depth_within(mesh, whole(mesh), 0.29));
  EXPECT_NEAR(*depth_within(mesh, whole(mesh), 0.31), 0.3, 1e-15);
}

TEST(HullDepth, OfAFlatPatchIsZero) {
  const Mesh mesh = dented_cube(0.7);
  EXPECT_EQ(hull_depths(mesh, {0}).deepest(), 0);
}

TEST(Ridges, AreTheTwoEndsOfADumbbell) {
  const Mesh mesh = dumbbell();
  const PatchVertices patch = hull_depths(mesh, whole(mesh));
  const auto ridges = deepest_ridges(mesh, whole(mesh), patch, 0);
  ASSERT_TRUE(ridges);
  EXPECT_NEAR(ridges->saddle, patch.deepest(), 1e-9);  // the tube is narrowest
  const char bottom = ridges->side_of_vertex.front(), top = ridges->side_of_vertex.back();
  EXPECT_NE(bottom, top);
  EXPECT_TRUE(bottom != 0 && top != 0);
}

TEST(Ridges, OfADentAreOne) {
  const Mesh mesh = dented_cube(0.4);
  EXPECT_FALSE(deepest_ridges(mesh, whole(mesh), hull_depths(mesh, whole(mesh)), 0));
}

TEST(PartAtFault, AlwaysLeavesFacesOnBothSides) {
  const Mesh mesh = dented_cube(0.2);
  for (const std::vector<int>& faces : {whole(mesh), std::vector<int>{2, 4}})
    EXPECT_TRUE(both_given(part_at_fault(mesh, faces, hull_depths(mesh, faces), 0, {})));
}

TEST(Convexity, LeavesAConvexMeshWhole) { EXPECT_EQ(count_parts(cut_by_convexity(Mesh(cube()), {1e-6})), 1); }

TEST(Convexity, CutsADumbbellInTwoAtItsTube) {
  const std::vector<int> labels = cut_by_convexity(dumbbell(), {0.05});
  EXPECT_EQ(count_parts(labels), 2);
  EXPECT_NE(labels.front(), labels.back());
}

TEST(Convexity, CutsADeepDentThatHasNoRidges) {
  EXPECT_GT(count_parts(cut_by_convexity(dented_cube(0.3), {0.05})), 1);
  EXPECT_EQ(count_parts(cut_by_convexity(dented_cube(0.95), {0.05})), 1);
}

TEST(Convexity, RefusesABoundOfZero) { EXPECT_THROW(cut_by_convexity(Mesh(cube()), {0}), InvalidOption); }

TEST(Convexity, KeepsTheBoundWhenThereIsNoTime) {
  const Mesh mesh = dumbbell();
  const std::vector<int> labels = cut_by_convexity(mesh, {0.01}, limited(plico::Run{}, 0));
  std::vector<std::vector<int>> parts(count_parts(labels));
  for (FaceId f : mesh.faces()) parts[labels[f]].push_back(f);
  for (const std::vector<int>& faces : parts) EXPECT_LE(hull_depths(mesh, faces).deepest(), 0.01 * diagonal(mesh));
}

}  // namespace
}  // namespace plico
