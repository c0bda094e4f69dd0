#include "plico/shapes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

struct Solid {
  std::string name;
  PolygonSoup soup;
  int vertices, faces, genus;
};

std::vector<Solid> solids() {
  const Mesh tetra(tetrahedron()), hexa(cube()), octa(octahedron()), dodeca(dodecahedron()), icosa(icosahedron());
  const double golden = (1 + std::sqrt(5.0)) / 2;
  return {{"tetrahedron", tetrahedron(), 4, 4, 0},
          {"cube", cube(), 8, 6, 0},
          {"octahedron", octahedron(), 6, 8, 0},
          {"dodecahedron", dodecahedron(), 20, 12, 0},
          {"icosahedron", icosahedron(), 12, 20, 0},
          {"truncated tetrahedron", truncated(tetra, 3), 12, 8, 0},
          {"truncated cube", truncated(hexa, 4), 24, 14, 0},
          {"truncated octahedron", truncated(octa, 3), 24, 14, 0},
          {"truncated dodecahedron", truncated(dodeca, 5), 60, 32, 0},
          {"truncated icosahedron", truncated(icosa, 3), 60, 32, 0},
          {"cuboctahedron", rectified(hexa), 12, 14, 0},
          {"icosidodecahedron", rectified(icosa), 30, 32, 0},
          {"small stellated dodecahedron", spiked(dodeca, golden), 32, 60, 0},
          {"great stellated dodecahedron", spiked(icosa, golden), 32, 60, 0},
          {"stella octangula", spiked(octa, 1), 14, 24, 0},
          {"prism", prism(7), 14, 9, 0},
          {"pyramid", frustum(4, 0, 1.6), 5, 5, 0},
          {"frustum", frustum(6, 0.5, 1), 12, 8, 0},
          {"house", house(), 10, 7, 0},
          {"antiprism", antiprism(5), 10, 12, 0},
          {"geodesic sphere", geodesic_sphere(5), 252, 500, 0},
          {"torus", torus(12, 7), 84, 84, 1},
          {"quad cube", quad_cube(3), 56, 54, 0}};
}

double worst_planarity(const Mesh& mesh) {
  double worst = 0;
  for (FaceId f : mesh.faces())
    for (int v : mesh.corners(f))
      worst = std::max(worst, std::abs(normal(mesh, f).dot(mesh.point(VertexId(v)) - center(mesh, f))));
  return worst;
}

TEST(Shapes, AreClosedPlanarAndFaceOutward) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const Mesh mesh(solid.soup);
    EXPECT_EQ(mesh.num_vertices(), solid.vertices);
    EXPECT_EQ(mesh.num_faces(), solid.faces);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(components(mesh).count, 1);
    EXPECT_EQ(genus(mesh), solid.genus);
    EXPECT_GT(volume(mesh), 0);
    EXPECT_LT(worst_planarity(mesh), 1e-14);
  }
}

TEST(Shapes, PlatonicAndArchimedeanSolidsHaveEqualEdges) {
  const auto all = solids();
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(all[i].name);
    const Mesh mesh(all[i].soup);
    for (EdgeId e : mesh.edges()) EXPECT_NEAR(length(mesh, e), length(mesh, EdgeId(0)), 1e-14);
  }
}

// The spikes of a stellation continue the planes of the faces around them.
TEST(Shapes, StellatedDodecahedronHasTwelvePlanes) {
  const Mesh star(spiked(Mesh(dodecahedron()), (1 + std::sqrt(5.0)) / 2));
  for (FaceId f : star.faces()) {
    int in_same_plane = 0;
    for (FaceId g : star.faces())
      in_same_plane += normal(star, f).dot(normal(star, g)) > 1 - 1e-12 &&
                       std::abs(normal(star, f).dot(center(star, f) - center(star, g))) < 1e-12;
    EXPECT_EQ(in_same_plane, 5);
  }
}

TEST(Shapes, GridIsOpen) {
  const Mesh grid(open_grid(3, 2));
  EXPECT_EQ(grid.num_faces(), 6);
  EXPECT_EQ(boundary_loops(grid).size(), 1u);
  EXPECT_NEAR(surface_area(grid), 6, 1e-12);
}

TEST(Shapes, NumbersOutOfRangeAreNamed) {
  EXPECT_THROW(geodesic_sphere(0), InvalidOption);
  EXPECT_THROW(torus(2, 5), InvalidOption);
  EXPECT_THROW(torus(5, 5, 1.0), InvalidOption);
  EXPECT_THROW(prism(2), InvalidOption);
  EXPECT_THROW(spiked(Mesh(cube()), 0.7), InvalidOption);
  EXPECT_THROW(truncated(Mesh(open_grid(1, 1)), 4), InvalidInput);
}

}  // namespace
}  // namespace plico
