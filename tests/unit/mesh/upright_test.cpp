#include "plico/mesh/upright.h"

#include <gtest/gtest.h>

#include "plico/shapes/named_shapes.h"

namespace plico {
namespace {

Mesh turned_to_z(const Mesh& mesh) {
  PolygonSoup soup = mesh.soup();
  for (Vec3& p : soup.points) p = z_up_from('y') * p;
  return Mesh(soup);
}

TEST(Upright, WhatStandsOnItsBaseIsUpAlongIt) {
  for (const char* name : {"pyramid", "cone", "frustum", "house"}) {
    SCOPED_TRACE(name);
    const Mesh mesh(make_shape(name));
    EXPECT_EQ(guessed_up(mesh), 'y');
    EXPECT_EQ(guessed_up(turned_to_z(mesh)), 'z');
  }
}

// Head, tail, back and belly differ; left and right do not, as in an animal.
TEST(Upright, EqualHalvesLieLeftAndRightOfTheAxisThatIsNotUp) {
  PolygonSoup soup = make_shape("octahedron");
  for (Vec3& p : soup.points) {
    if (p.x() > 0.5) p = Vec3(2, 0, 0.3);
    if (p.x() < -0.5) p = Vec3(-1, 0, -0.2);
    if (p.z() > 0.5) p = Vec3(0.2, 0, 1.5);
  }
  EXPECT_EQ(guessed_up(Mesh(soup)), 'z');
  for (Vec3& p : soup.points) p = z_up_from('y').transpose() * p;
  EXPECT_EQ(guessed_up(Mesh(soup)), 'y');
}

// Three boxes on one floor, one of them three times as tall; standing in a row, in depth, or anyhow.
TEST(Upright, PiecesThatShareTheirFloorStandOnIt) {
  for (const Vec3& step : {Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(2, 1.5, 0)}) {
    PolygonSoup soup;
    for (int i = 0; i < 3; ++i) {
      const PolygonSoup box = make_shape("cube");
      Eigen::AlignedBox3d around;
      for (const Vec3& p : box.points) around.extend(p);
      const int first = soup.num_points();
      for (const Vec3& p : box.points) {
        Vec3 at = (p - around.min()).cwiseQuotient(around.sizes());
        if (i == 2) at.z() *= 3;
        soup.points.push_back(at + i * step);
      }
      for (int f = 0; f < box.num_faces(); ++f) {
        std::vector<int> corners;
        for (int v : box.face(f)) corners.push_back(first + v);
        soup.add_face(corners);
      }
    }
    EXPECT_EQ(guessed_up(Mesh(soup)), 'z');
    for (Vec3& p : soup.points) p = z_up_from('y').transpose() * p;
    EXPECT_EQ(guessed_up(Mesh(soup)), 'y');
  }
}

TEST(Upright, WithNothingToTellItIsY) { EXPECT_EQ(guessed_up(Mesh(make_shape("cube"))), 'y'); }

}  // namespace
}  // namespace plico
