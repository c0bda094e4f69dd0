#include "plico/mesh/submesh.h"

#include <gmock/gmock.h>

#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::ElementsAre;

TEST(Submesh, KeepsFacesEdgesAndShapesOfItsFaces) {
  const Mesh whole{cube()};
  const Submesh part = submesh(whole, {FaceId(4), FaceId(1)});
  EXPECT_THAT(part.face, ElementsAre(1, 4));
  for (FaceId f : part.mesh.faces()) EXPECT_NEAR(area(part.mesh, f), area(whole, FaceId(part.face[f])), 1e-15);
  for (EdgeId e : part.mesh.edges()) EXPECT_EQ(length(part.mesh, e), length(whole, EdgeId(part.edge[e])));
}

TEST(Submesh, FacesThatMeetOnlyInAVertexGetOneEach) {
  const Mesh whole{octahedron()};
  FaceId other(1);
  while (other < 8) {
    int common = 0;
    for (int v : whole.corners(FaceId(0)))
      for (int w : whole.corners(other)) common += v == w;
    if (common == 1) break;
    other = FaceId(other + 1);
  }
  ASSERT_LT(other, 8);
  const Submesh part = submesh(whole, {FaceId(0), other});
  EXPECT_EQ(part.mesh.num_vertices(), 6);
  EXPECT_EQ(part.mesh.num_edges(), 6);
}

TEST(Submesh, OfAllFacesIsTheWhole) {
  const Mesh whole{geodesic_sphere(2)};
  const auto all = whole.faces();
  std::vector<FaceId> faces;
  for (FaceId f : all) faces.push_back(f);
  const Submesh part = submesh(whole, faces);
  EXPECT_EQ(part.mesh.num_vertices(), whole.num_vertices());
  EXPECT_EQ(part.mesh.num_edges(), whole.num_edges());
  EXPECT_TRUE(is_closed(part.mesh));
}

}  // namespace
}  // namespace plico
