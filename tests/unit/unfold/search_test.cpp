#include "plico/unfold/search.h"

#include <gtest/gtest.h>

#include "judged_net.h"
#include "mesh_samples.h"
#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/unfold/exhaust.h"
#include "plico/unfold/overlap.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

Mesh two_tetrahedra() {
  PolygonSoup soup = tetrahedron();
  const PolygonSoup one = soup;
  for (const Vec3& p : one.points) soup.points.emplace_back(p + Vec3(10, 0, 0));
  for (int f = 0; f < one.num_faces(); ++f) {
    std::vector<int> face;
    for (int v : one.face(f)) face.push_back(v + one.num_points());
    soup.add_face(face);
  }
  return Mesh(soup);
}

TEST(Search, FindsOneNetOfABumpySphereForEverySeed) {
  const Mesh mesh = bumpy_sphere(2, 0.25, 3);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const SearchResult result = find_net(mesh, {.seed = seed});
    EXPECT_EQ(result.ending, Ending::Found);
    EXPECT_EQ(result.parts, 1);
    EXPECT_TRUE(judge(mesh, result.forest).is_net());
  }
}

TEST(Search, UntanglesFourThousandFaces) {
  const Mesh mesh = bumpy_sphere(4, 0.02, 1);
  const SearchResult result = find_net(mesh);
  EXPECT_GT(result.start_overlaps, 0);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_TRUE(judge(mesh, result.forest).is_net());
}

TEST(Search, GivesEveryComponentItsOwnNet) {
  const Mesh mesh = two_tetrahedra();
  const SearchResult result = find_net(mesh);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_EQ(result.parts, 2);
  EXPECT_TRUE(judge(mesh, result.forest).valid());
}

TEST(Search, IsTheSameForOneAndTwoThreads) {
  const Mesh mesh = bumpy_sphere(3, 0.1, 5);
  plico::Run two;
  two.threads = 2;
  EXPECT_EQ(find_net(mesh, {.seed = 7}).forest, find_net(mesh, {.seed = 7}, two).forest);
}

TEST(Search, ProvesThatASaddleFanHasNoNet) {
  const Mesh fan = saddle_fan(8, kPi / 3);
  ASSERT_NEAR(angle_sum(fan, VertexId(0)), 8 * kPi / 3, 1e-12);
  const SearchResult result = find_net(fan);
  EXPECT_EQ(result.ending, Ending::Exhausted);
  EXPECT_TRUE(result.proven_impossible);
  EXPECT_FALSE(result.in_the_way.empty());
  EXPECT_EQ(result.parts, 2);
  EXPECT_TRUE(judge(fan, result.forest).valid());
}

TEST(Search, StopsAtOnceWithPartsThatDoNotOverlap) {
  const Mesh mesh = bumpy_sphere(4, 0.02, 1);
  const SearchResult result = find_net(mesh, {}, limited(plico::Run{}, 0));
  EXPECT_EQ(result.ending, Ending::TimedOut);
  EXPECT_GT(result.parts, 1);
  EXPECT_FALSE(result.in_the_way.empty());
  EXPECT_FALSE(result.proven_impossible);
  EXPECT_TRUE(judge(mesh, result.forest).valid());
}

TEST(Search, RepeatsATimedOutRunByItsSteps) {
  const Mesh mesh = bumpy_sphere(4, 0.02, 1);
  const SearchResult some = find_net(mesh, {.max_steps = 50});
  EXPECT_EQ(some.ending, Ending::Exhausted);
  EXPECT_EQ(some.steps, 50);
  EXPECT_EQ(some.forest, find_net(mesh, {.max_steps = 50}).forest);
}

TEST(Search, RejectsOptionsOutOfRange) {
  EXPECT_THROW(find_net(tetrahedron_mesh(), {.starts = 0}), InvalidOption);
  EXPECT_THROW(find_net(tetrahedron_mesh(), {.effort = 0}), InvalidOption);
  EXPECT_THROW(find_net(tetrahedron_mesh(), {.max_steps = -2}), InvalidOption);
}

TEST(TryAllNets, FindsTheTetrahedronsAndCountsWhatItLookedAt) {
  const Mesh mesh = tetrahedron_mesh();
  const ExhaustResult result = try_all_nets(FlatFaces(mesh), 1000);
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_GT(result.nodes, 2);
  EXPECT_TRUE(judge(mesh, result.net).is_net());
}

TEST(TryAllNets, GivesUpUndecidedAtItsLimit) {
  const ExhaustResult result = try_all_nets(FlatFaces(saddle_fan(8, kPi / 3)), 3);
  EXPECT_EQ(result.ending, Ending::Exhausted);
  EXPECT_FALSE(result.decided);
}

}  // namespace
}  // namespace plico
