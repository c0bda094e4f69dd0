#include "plico/mesh/measures.h"

#include <gtest/gtest.h>

namespace plico {
namespace {

Mesh box(double x, double y, double z, bool closed = true) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) soup.points.emplace_back(i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
  for (auto face : {std::array{0, 2, 3, 1}, std::array{0, 1, 5, 4}, std::array{1, 3, 7, 5}, std::array{3, 2, 6, 7},
                    std::array{2, 0, 4, 6}})
    soup.add_face(face);
  if (closed) soup.add_face({4, 5, 7, 6});
  return Mesh(std::move(soup));
}

Mesh torus(int n, int m) {
  PolygonSoup soup;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * kPi * i / n, v = 2 * kPi * j / m, r = 3 + std::cos(v);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  const auto at = [&](int i, int j) { return i % n * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) soup.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return Mesh(std::move(soup));
}

TEST(Measures, ABox) {
  const Mesh mesh = box(1, 2, 3);
  EXPECT_DOUBLE_EQ(volume(mesh), 6);
  EXPECT_DOUBLE_EQ(surface_area(mesh), 22);
  EXPECT_DOUBLE_EQ(diagonal(mesh), std::sqrt(14));
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), 2);
  EXPECT_EQ(mesh.num_edges(), 12);
  EXPECT_EQ(genus(mesh), 0);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_TRUE(is_convex(mesh));
  for (EdgeId e : mesh.edges()) EXPECT_DOUBLE_EQ(fold_angle(mesh, e), -kPi / 2);  // mountain
  for (VertexId v : mesh.vertices()) {
    EXPECT_DOUBLE_EQ(angle_sum(mesh, v), 1.5 * kPi);
    EXPECT_FALSE(is_hyperbolic(mesh, v));
  }
}

TEST(Measures, ABoxWithoutItsLid) {
  const Mesh mesh = box(1, 1, 1, false);
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_FALSE(is_convex(mesh));
  EXPECT_EQ(genus(mesh), 0);
  ASSERT_EQ(boundary_loops(mesh).size(), 1u);
  EXPECT_EQ(boundary_loops(mesh)[0].size(), 4u);
  int boundary = 0;
  for (VertexId v : mesh.vertices()) boundary += is_boundary(mesh, v);
  EXPECT_EQ(boundary, 4);
}

TEST(Measures, ATorusHasGenusOneAndHyperbolicVerticesInside) {
  const Mesh mesh = torus(24, 12);
  EXPECT_EQ(genus(mesh), 1);
  EXPECT_EQ(components(mesh).count, 1);
  EXPECT_FALSE(is_convex(mesh));
  EXPECT_NEAR(volume(mesh), 2 * kPi * kPi * 3, 0.1 * 2 * kPi * kPi * 3);
  EXPECT_TRUE(is_hyperbolic(mesh, VertexId(6)));   // v = pi: the side of the hole
  EXPECT_FALSE(is_hyperbolic(mesh, VertexId(0)));  // v = 0: the outer side
}

// Gauss and Bonnet: the angles missing at the vertices sum to 2 pi times V - E + F.
TEST(MeasuresLaw, GaussBonnet) {
  for (const Mesh& mesh : {box(1, 2, 3), torus(7, 5), torus(24, 12)}) {
    double curvature = 0;
    for (VertexId v : mesh.vertices()) curvature += 2 * kPi - angle_sum(mesh, v);
    const int euler = mesh.num_vertices() - mesh.num_edges() + mesh.num_faces();
    EXPECT_EQ(euler, 2 - 2 * genus(mesh));
    // The torus' quads are flat, so their angles sum to 2 pi.
    EXPECT_NEAR(curvature, 2 * kPi * euler, 1e-9);
  }
}

TEST(MeasuresLaw, AReflexCornerCountsBeyondPi) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}};
  soup.add_face({0, 1, 2, 3, 4});
  const Mesh mesh(std::move(soup));
  double sum = 0;
  for (HalfedgeId h : mesh.halfedges(FaceId(0))) sum += corner_angle(mesh, h);
  EXPECT_NEAR(sum, 3 * kPi, 1e-12);
  EXPECT_GT(corner_angle(mesh, HalfedgeId(3)), kPi);
  EXPECT_DOUBLE_EQ(area(mesh, FaceId(0)), 2.5);
}

}  // namespace
}  // namespace plico
