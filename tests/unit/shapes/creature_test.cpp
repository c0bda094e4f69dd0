#include "plico/shapes/creature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "effort.h"
#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/self_intersections.h"
#include "plico/mesh/simplify.h"
#include "plico/shapes/isosurface.h"
#include "plico/shapes/named_shapes.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

void expect_animal(const PolygonSoup& soup, int faces) {
  const Mesh mesh(soup);
  EXPECT_EQ(mesh.num_faces(), faces);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(components(mesh).count, 1);
  EXPECT_EQ(genus(mesh), 0);
  EXPECT_GT(volume(mesh), 0);
}

// 1 equilateral, 0 degenerate.
double quality(const Mesh& mesh, FaceId f) {
  double sides = 0;
  for (HalfedgeId h : mesh.halfedges(f)) sides += std::pow(length(mesh, mesh.edge(h)), 2);
  return 4 * std::sqrt(3.0) * area(mesh, f) / sides;
}

TEST(Creature, EveryAnimalIsOneClosedBallOfTheFacesAskedFor) {
  for (Animal animal : kAnimals) {
    for (int faces : {100, kSanitized ? 301 : 1501}) {
      SCOPED_TRACE(std::string(name(animal)) + " " + std::to_string(faces));
      const PolygonSoup soup = creature({.animal = animal, .faces = faces});
      expect_animal(soup, faces / 2 * 2);
      EXPECT_TRUE(self_intersections(soup).empty());
    }
  }
}

TEST(Creature, TrianglesAreWellShaped) {
  for (Animal animal : kAnimals) {
    const Mesh mesh(creature({.animal = animal, .faces = 1000}));
    double mean = 0, worst = 1;
    for (FaceId f : mesh.faces()) {
      mean += quality(mesh, f) / mesh.num_faces();
      worst = std::min(worst, quality(mesh, f));
    }
    EXPECT_GT(mean, 0.7) << name(animal);
    EXPECT_GT(worst, 0.02) << name(animal);
  }
}

TEST(Creature, StrayingAnimalsAreAnimalsTooAndAllDifferent) {
  double last = 0;
  for (int seed = 1; seed <= num_cases(3); ++seed) {
    SCOPED_TRACE(seed);
    for (Animal animal : kAnimals) {
      const PolygonSoup soup =
          creature({.animal = animal, .faces = 400, .variety = 1, .seed = static_cast<std::uint64_t>(seed)});
      expect_animal(soup, 400);
      EXPECT_NE(volume(Mesh(soup)), last);
      last = volume(Mesh(soup));
    }
  }
}

TEST(Creature, SameOptionsGiveTheSameMesh) {
  const CreatureOptions options{.animal = Animal::Dog, .faces = 500, .variety = 0.5, .seed = 3};
  const PolygonSoup a = creature(options), b = creature(options);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.corners, b.corners);
}

TEST(Creature, ManyFacesStayExact) { expect_animal(creature({.animal = Animal::Dog, .faces = 8000}), 8000); }

TEST(Creature, OptionsOutOfRangeAreNamed) {
  EXPECT_THROW(creature({.faces = 99}), InvalidOption);
  EXPECT_THROW(creature({.variety = 1.5}), InvalidOption);
}

TEST(Isosurface, OfABallIsABall) {
  const double radius = 0.5;
  const SmoothBody ball({{Vec3::Zero(), Vec3::Zero(), radius, radius}});
  const Mesh mesh(isosurface(ball, 0.03));
  expect_animal(mesh.soup(), mesh.num_faces());
  EXPECT_NEAR(volume(mesh), 4.0 / 3 * kPi * radius * radius * radius, 0.01);
  for (const Vec3& p : mesh.soup().points) EXPECT_NEAR(p.norm(), radius, 0.01);
}

TEST(SmoothBody, IsNeverSteeperThanItSays) {
  const SmoothBody body = creature_body({.animal = Animal::Fish});
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = Vec3::Random(), q = p + 0.1 * Vec3::Random();
    EXPECT_LE(std::abs(body.value(p) - body.value(q)), body.steepness() * (p - q).norm() + 1e-12);
  }
}

TEST(Simplify, KeepsTheShapeOfASphere) {
  const Mesh sphere(geodesic_sphere(12)), small(simplified(sphere, {.faces = 400}));
  expect_animal(small.soup(), 400);
  EXPECT_NEAR(volume(small), volume(sphere), 0.05 * volume(sphere));
}

TEST(Simplify, KeepsTheHoleOfATorus) {
  PolygonSoup triangles;
  const PolygonSoup ring = torus(24, 16);
  triangles.points = ring.points;
  for (int f = 0; f < ring.num_faces(); ++f) {
    const auto c = ring.face(f);
    triangles.add_face({c[0], c[1], c[2]});
    triangles.add_face({c[0], c[2], c[3]});
  }
  const Mesh small(simplified(Mesh(triangles), {.faces = 4}));
  EXPECT_EQ(genus(small), 1);
  EXPECT_GE(small.num_faces(), 14);  // no torus has fewer
}

TEST(Simplify, RefusesPolygonsAndOpenMeshes) {
  EXPECT_THROW(simplified(Mesh(cube())), InvalidInput);
  EXPECT_THROW(simplified(Mesh(tetrahedron()), {.faces = 2}), InvalidOption);
  EXPECT_EQ(simplified(Mesh(tetrahedron()), {.faces = 4}).num_faces(), 4);
}

TEST(NamedShapes, AllCanBeMade) {
  for (const NamedShape& shape : named_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh(make_shape(shape.name));
    EXPECT_EQ(is_closed(mesh), shape.name != "grid");
    if (shape.has_face_count) {
      const Mesh larger(make_shape(shape.name, {.faces = 1000}));
      EXPECT_NEAR(larger.num_faces(), 1000, 60);
    } else {
      EXPECT_THROW(make_shape(shape.name, {.faces = 1000}), InvalidOption);
    }
  }
}

TEST(NamedShapes, UnknownNameAndMisplacedVarietyAreRefused) {
  EXPECT_THROW(make_shape("unicorn"), InvalidOption);
  EXPECT_THROW(make_shape("cube", {.variety = 0.5}), InvalidOption);
}

}  // namespace
}  // namespace plico
