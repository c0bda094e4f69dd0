#include "plico/inflate/inflate.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/inflate/explicit.h"
#include "plico/shapes/creature.h"
#include "plico/shapes/shapes.h"
#include "plico/verify/inflation.h"

namespace plico {
namespace {

Mesh small_bird() { return Mesh(creature({.animal = Animal::Bird, .faces = 100})); }

PolygonSoup with_points(const Mesh& mesh, const std::vector<Vec3>& points) {
  PolygonSoup soup = mesh.soup();
  soup.points = points;
  return soup;
}

TEST(Inflate, HalfOfTheHyperbolicVerticesGoWithinTheGrowthAllowed) {
  const Mesh bird = small_bird();
  const Inflation result = inflate(bird, {.stronger = {}});
  const InflationVerdict verdict = verify_inflation(bird, with_points(bird, result.points), {}, 0.05);
  EXPECT_TRUE(verdict.valid());
  EXPECT_LE(2 * verdict.hyperbolic, verdict.hyperbolic_before);
}

TEST(Inflate, TheBestLevelWithinTheLimitIsKept) {
  const Mesh bird = small_bird();
  const Inflation early = inflate(bird, {.stronger = {}, .pressure = 0.02});
  const Inflation late = inflate(bird, {.stronger = {}, .pressure = 0.2});
  EXPECT_LE(late.hyperbolic, early.hyperbolic);
  EXPECT_EQ(late.hyperbolic, count_hyperbolic(Mesh(with_points(bird, late.points))));
}

TEST(Inflate, AStrongerSkinIsTakenOnlyWhenItDoesBetter) {
  const Mesh bird = small_bird();
  const Inflation one = inflate(bird, {.stronger = {}, .pressure = 0.02});
  const Inflation several = inflate(bird, {.stronger = {8}, .pressure = 0.02});
  EXPECT_LE(several.hyperbolic, one.hyperbolic);
  EXPECT_TRUE(verify_inflation(bird, with_points(bird, several.points), {}, 0.05).valid());
}

TEST(Inflate, TheExcessIsThatOfTheHyperbolicVertices) {
  EXPECT_EQ(angle_excess(Mesh(icosahedron())), 0);
  const Mesh bird = small_bird();
  const Inflation result = inflate(bird, {.stronger = {}, .pressure = 0.02});
  EXPECT_EQ(result.excess_before, angle_excess(bird));
  EXPECT_LT(result.excess, result.excess_before);
}

TEST(Inflate, KeptFacesStayToTheLastBit) {
  const Mesh bird = small_bird();
  const std::vector<FaceId> keep{FaceId(3), FaceId(40)};
  const Inflation result = inflate(bird, {.stronger = {}, .pressure = 0.02, .keep = keep});
  EXPECT_TRUE(verify_inflation(bird, with_points(bird, result.points), keep, 0.05).valid());
}

TEST(Inflate, AConvexMeshIsLeftAlone) {
  const Inflation result = inflate(Mesh(icosahedron()));
  EXPECT_EQ(result.limit, InflateLimit::Hyperbolic);
  EXPECT_EQ(result.largest_move(), 0);
}

TEST(Inflate, StepsOfTimeEndToo) {
  const Mesh bird = small_bird();
  const Inflation result = inflate(bird, {.method = InflateMethod::Explicit, .pressure = 0.1, .max_steps = 100});
  EXPECT_TRUE(verify_inflation(bird, with_points(bird, result.points), {}, 0.05).valid());
}

InflateOptions balloon(int steps) {
  return {.method = InflateMethod::Explicit, .max_growth = 2, .pressure = 0.05, .max_steps = steps};
}

TEST(Inflate, StepsOfTimeOneByOneAreTheStepsAtOnce) {
  const Mesh bird = small_bird();
  ExplicitInflation slow(bird, balloon(35));
  std::vector<int> steps;
  while (slow.advance()) steps.push_back(slow.result().steps);
  EXPECT_EQ(steps, (std::vector<int>{10, 20, 30}));
  EXPECT_EQ(slow.result().steps, 35);
  EXPECT_EQ(slow.result().points, inflate(bird, balloon(35)).points);
  EXPECT_NE(slow.result().points, bird.soup().points);
}

TEST(Inflate, PinnedVerticesStayWhereTheyAre) {
  const Mesh bird = small_bird();
  const std::vector<VertexId> pins{VertexId(2), VertexId(17)};
  InflateOptions options = balloon(20);
  const auto verdict = [&] {
    return verify_inflation(bird, with_points(bird, inflate(bird, options).points), {}, options.max_growth, pins);
  };
  EXPECT_FALSE(verdict().valid());
  options.keep_vertices = pins;
  EXPECT_TRUE(verdict().valid());
  options.method = InflateMethod::Minimize;
  options.stronger.clear();
  EXPECT_TRUE(verdict().valid());
  options.keep_vertices = {VertexId(bird.num_vertices())};
  EXPECT_THROW(inflate(bird, options), InvalidOption);
}

TEST(Inflate, AMeshWithABoundaryOrPolygonsIsRefused) {
  EXPECT_THROW(inflate(Mesh(open_grid(2, 2))), InvalidInput);
  EXPECT_THROW(inflate(Mesh(cube())), InvalidInput);
}

TEST(VerifyInflation, AVolumeThatShrankTooFarIsFound) {
  const Mesh solid(icosahedron());
  PolygonSoup small = solid.soup();
  for (Vec3& p : small.points) p *= 0.9;
  EXPECT_FALSE(verify_inflation(solid, small, {}, 0.05).valid());
  EXPECT_TRUE(verify_inflation(solid, small, {}, 0.3).valid());
}

TEST(VerifyInflation, AFaceThatTurnedOverIsFound) {
  const Mesh solid(icosahedron());
  PolygonSoup bad = solid.soup();
  bad.points[0] = -bad.points[0];
  EXPECT_FALSE(verify_inflation(solid, bad, {}, 1).valid());
}

}  // namespace
}  // namespace plico
