#include "plico/convex/remesh.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/rng.h"
#include "plico/verify/shells.h"

namespace plico {
namespace {

ShapePart ball_part(const std::string& name, const Vec3& center, int points, std::uint64_t seed) {
  Rng rng(seed);
  ShapePart part{name, {}};
  for (int i = 0; i < points; ++i) {
    const double x = rng.normal(), y = rng.normal();
    part.points.push_back(center + Vec3(x, y, rng.normal()).normalized());
  }
  return part;
}

// A drum of `sides` quads and two flat ends.
ShapePart drum_part(int sides) {
  ShapePart part{"drum", {}};
  for (int i = 0; i < sides; ++i)
    for (double z : {0.0, 1.0})
      part.points.emplace_back(plico::cos(2 * kPi * i / sides), plico::sin(2 * kPi * i / sides), z);
  return part;
}

ShellsClaim claim_of_surfaces(const Shells& shells) {
  ShellsClaim claim;
  for (const Shell& shell : shells.shells) {
    ShellsClaim::Shell surface;
    surface.surface.points = shell.body.points;
    for (const auto& facet : shell.body.facets) surface.surface.add_face(facet.corners);
    claim.shells.push_back(std::move(surface));
  }
  for (const ShellContact& contact : shells.contacts)
    claim.contacts.push_back({contact.first, contact.second, contact.plane, contact.polygon});
  return claim;
}

ShellsVerdict judged(const Shells& before, const Shells& after, double max_growth) {
  return verify_remeshed_shells({claim_of_surfaces(before), claim_of_surfaces(after), max_growth});
}

TEST(Remesh, ABallLosesHalfOfItsTrianglesForLittleVolume) {
  const Shells ball = disjoint_shells({ball_part("ball", {0, 0, 0}, 60, 1)});
  const Remeshing result = remesh(ball, {.faces = 58, .max_growth = 0.1});
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_LE(result.changes[0].triangles, 58);
  EXPECT_TRUE(judged(ball, result.shells, 0.1).valid());
}

TEST(Remesh, EndsAtTheGrowthAllowed) {
  const Shells ball = disjoint_shells({ball_part("ball", {0, 0, 0}, 60, 1)});
  const Remeshing result = remesh(ball, {.faces = 4, .max_growth = 0.02});
  EXPECT_EQ(result.ending, Ending::Exhausted);
  EXPECT_LE(result.changes[0].volume, 1.02 * result.changes[0].volume_before);
  EXPECT_LT(result.changes[0].triangles, result.changes[0].triangles_before);
  EXPECT_TRUE(judged(ball, result.shells, 0.02).valid());
}

TEST(Remesh, ADrumKeepsItsFlatEnds) {
  const Shells drum = disjoint_shells({drum_part(24)});
  const Remeshing result = remesh(drum, {.faces = 48, .max_growth = 0.1});
  EXPECT_LE(result.changes[0].triangles, 48);
  for (const Vec3& p : result.shells.shells[0].body.points) EXPECT_NEAR(p.z() * (p.z() - 1), 0, 1e-8);
  EXPECT_TRUE(judged(drum, result.shells, 0.1).valid());
}

TEST(Remesh, ShellsThatTouchStillDoAndStayApart) {
  const Shells two = disjoint_shells({ball_part("a", {0, 0, 0}, 60, 1), ball_part("b", {1.2, 0, 0}, 60, 2)});
  const Remeshing result = remesh(two, {.faces = 40, .regularize = 2, .max_growth = 0.1});
  ASSERT_EQ(result.shells.contacts.size(), 1u);
  EXPECT_GE(result.shells.contacts[0].polygon.size(), 3u);
  EXPECT_TRUE(judged(two, result.shells, 0.1).valid());
}

TEST(Remesh, ShellsThatWereApartDoNotGrowIntoEachOther) {
  const Shells two = disjoint_shells({ball_part("a", {0, 0, 0}, 40, 1), ball_part("b", {2.01, 0, 0}, 40, 2)});
  const Remeshing result = remesh(two, {.faces = 8, .max_growth = 1});
  EXPECT_EQ(result.shells.contacts.size(), 1u);
  EXPECT_TRUE(judged(two, result.shells, 1).valid());
}

TEST(Remesh, TrianglesBecomeFatter) {
  const Shells ball = disjoint_shells({ball_part("ball", {0, 0, 0}, 80, 3)});
  const Remeshing result = remesh(ball, {.regularize = 3, .max_growth = 0.1});
  EXPECT_GT(result.fatness, 1.1 * result.fatness_before);
  EXPECT_TRUE(judged(ball, result.shells, 0.1).valid());
}

TEST(Remesh, ATetrahedronStaysOne) {
  const Shells one = disjoint_shells({{"t", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  EXPECT_EQ(remesh(one, {.faces = 4, .max_growth = 1}).changes[0].triangles, 4);
}

TEST(Remesh, ThreadsChangeNothing) {
  const Shells two = disjoint_shells({ball_part("a", {0, 0, 0}, 40, 1), ball_part("b", {1.2, 0, 0}, 40, 2)});
  const Remeshing one = remesh(two, {.faces = 30, .regularize = 1}),
                  three = remesh(two, {.faces = 30, .regularize = 1}, {.threads = 3});
  for (int s = 0; s < 2; ++s) EXPECT_EQ(one.shells.shells[s].body.points, three.shells.shells[s].body.points);
}

TEST(Remesh, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(remesh({}, {.faces = 3}), InvalidOption);
  EXPECT_THROW(remesh({}, {.regularize = -1}), InvalidOption);
  EXPECT_THROW(remesh({}, {.max_growth = 0}), InvalidOption);
}

TEST(Fatness, OfARegularTetrahedronIsAHalf) {
  const std::vector<Vec3> points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_NEAR(fatness(convex_hull(points)), 0.5, 1e-12);
}

TEST(VerifyRemeshedShells, AShellThatLeavesAPointOutsideIsFound) {
  const Shells ball = disjoint_shells({ball_part("ball", {0, 0, 0}, 40, 1)});
  Shells smaller = ball;
  smaller.shells[0].body = clip(ball.shells[0].body, {Vec3::UnitX(), 0.8}, 0);
  smaller.shells[0].body = convex_hull(smaller.shells[0].body.points);
  EXPECT_FALSE(judged(ball, smaller, 0.1).valid());
}

TEST(VerifyRemeshedShells, AShellThatGrewTooMuchIsFound) {
  const Shells ball = disjoint_shells({ball_part("ball", {0, 0, 0}, 40, 1)});
  Shells larger = ball;
  for (Vec3& p : larger.shells[0].body.points) p *= 1.1;
  EXPECT_FALSE(judged(ball, larger, 0.1).valid());
  EXPECT_TRUE(judged(ball, larger, 0.4).valid());
}

}  // namespace
}  // namespace plico
