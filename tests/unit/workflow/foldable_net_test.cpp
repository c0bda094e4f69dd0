#include "plico/workflow/foldable_net.h"

#include <gtest/gtest.h>

#include "bumpy_sphere.h"
#include "plico/base/error.h"
#include "plico/unfold/foldable.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

TEST(FoldableNet, FindsANetWithAProvenMotion) {
  const Mesh mesh = bumpy_sphere(2, 0.1, 7);  // 128 faces
  for (FoldingLaw law : {FoldingLaw::Linear, FoldingLaw::Uniform}) {
    const FoldableNet found = find_foldable_net(mesh, {.law = law});
    ASSERT_EQ(found.ending, Ending::Found);
    EXPECT_EQ(found.proof.verdict, PathVerdict::Free);
    const Unfolding net = lay_flat(mesh, found.tree);
    EXPECT_EQ(net.num_parts(), 1);
    EXPECT_TRUE(verify_net(net, mesh).is_net());
    EXPECT_EQ(prove_path(linkage_of(net), found.path).verdict, PathVerdict::Free);
  }
}

TEST(FoldableNet, ThreadsDoNotChangeIt) {
  const Mesh mesh = bumpy_sphere(2, 0.1, 3);
  const FoldableNet one = find_foldable_net(mesh, {.seed = 5}, {.threads = 1});
  const FoldableNet two = find_foldable_net(mesh, {.seed = 5}, {.threads = 2});
  ASSERT_EQ(one.ending, Ending::Found);
  EXPECT_EQ(one.tree, two.tree);
  EXPECT_EQ(one.steps, two.steps);
}

TEST(FoldableNet, StoppedAtOnceStillHandsOutANetWithoutOverlap) {
  std::stop_source source;
  source.request_stop();
  const Mesh mesh = bumpy_sphere(2, 0.3, 3);
  const FoldableNet found = find_foldable_net(mesh, {}, {.stop = source.get_token()});
  EXPECT_EQ(found.ending, Ending::Stopped);
  EXPECT_TRUE(verify_net(lay_flat(mesh, found.tree), mesh).valid());
  EXPECT_NE(found.proof.verdict, PathVerdict::Free);
}

// A band of squares whose last one passes through the first.
Mesh crossing_band() {
  PolygonSoup band;
  for (const Vec2& p : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(1, 2), Vec2(1, -1)})
    for (int y : {0, 1}) band.points.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < 4; ++i) band.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return Mesh(band);
}

TEST(FoldableNet, AMeshThatPassesThroughItselfIsToldBeforeAnySearch) {
  const Mesh mesh = crossing_band();
  const NetAndMotion found = fold_or_plan(mesh);
  EXPECT_EQ(found.net.ending, Ending::Exhausted);
  EXPECT_TRUE(found.net.proven_impossible);
  EXPECT_EQ(found.net.crossing, (std::vector<std::pair<int, int>>{{0, 3}}));
  EXPECT_EQ(found.net.steps, 0);
  EXPECT_FALSE(found.motion);
  EXPECT_TRUE(verify_net(lay_flat(mesh, found.net.tree), mesh).is_net());
}

TEST(FoldableNet, TwoBodiesAreRefused) {
  PolygonSoup two = bumpy_sphere(0, 0, 1).soup();
  const PolygonSoup one = two;
  for (const Vec3& p : one.points) two.points.push_back(p + Vec3(5, 0, 0));
  for (int f = 0; f < one.num_faces(); ++f) two.add_face({one.face(f)[0] + 6, one.face(f)[1] + 6, one.face(f)[2] + 6});
  EXPECT_THROW(find_foldable_net(Mesh(two)), InvalidInput);
}

TEST(FoldableNet, OptionsAreChecked) {
  EXPECT_THROW(check(FoldableOptions{.lanes = 0}), InvalidOption);
  EXPECT_THROW(check(FoldableOptions{.temperature = 0}), InvalidOption);
  EXPECT_THROW(check(FoldableOptions{.coldest = 7}), InvalidOption);
  EXPECT_THROW(check(FoldableOptions{.nearby = 1.5}), InvalidOption);
  EXPECT_THROW(check(FoldableOptions{.seams = -0.1}), InvalidOption);
  EXPECT_THROW(check(FoldableOptions{.steps_per_recooling = 0}), InvalidOption);
}

}  // namespace
}  // namespace plico
