#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/motion/clear_trees.h"
#include "plico/verify/net.h"
#include "plico/workflow/foldable_net.h"

namespace plico {
namespace {

PanelKit square_and_triangles() {
  // A square with a triangle over each side, all in one plane: four joints, one spanning tree.
  PanelKit kit;
  kit.outlines = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  kit.twin = {4, 7, 10, 13};
  kit.first_side = {0, 4};
  for (int i = 0; i < 4; ++i) {
    kit.outlines.push_back({{0, 0}, {1, 0}, {0.5, 0.2}});
    kit.twin.insert(kit.twin.end(), {i, -1, -1});
    kit.first_side.push_back(kit.first_side.back() + 3);
  }
  kit.fold_angle.assign(kit.twin.size(), 1);
  return kit;
}

// A cube with a tall pyramid on every side.
Mesh spiky_cube() {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) soup.points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (int axis = 0; axis < 3; ++axis) {
    for (int sign : {-1, 1}) {
      Vec3 apex = Vec3::Zero();
      apex[axis] = 4 * sign;
      soup.points.push_back(apex);
      const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = sign > 0 ? 1 << axis : 0;
      const int corners[] = {base, base | u, base | u | v, base | v};
      const int top = static_cast<int>(soup.points.size()) - 1;
      for (int i = 0; i < 4; ++i) {
        const int a = corners[i], b = corners[(i + 1) % 4];
        soup.add_face(sign > 0 ? std::vector<int>{a, b, top} : std::vector<int>{b, a, top});
      }
    }
  }
  return Mesh(soup);
}

TEST(ClearTrees, VisitsEverySpanningTreeOnce) {
  int visits = 0;
  const ClearTrees trees = find_clear_trees(square_and_triangles(), {.clearance = 1e-3, .touch = 1e-6},
                                            [&](const std::vector<char>& joined) {
                                              EXPECT_EQ(std::count(joined.begin(), joined.end(), 1), 8);
                                              return ++visits == 2;
                                            });
  EXPECT_EQ(visits, 1);
  EXPECT_TRUE(trees.complete);
}

// Six triangles around a vertex, corners up and down in turn: the angles there sum up to 2 pi and 5e-4, so that every
// tree overlaps, but by less than the clearance with which motions are judged.
TEST(FoldableNet, AnOverlapShallowerThanTheClearanceIsNoNet) {
  PolygonSoup saddle;
  saddle.points.emplace_back(0, 0, 0);
  for (int i = 0; i < 6; ++i)
    saddle.points.emplace_back(std::cos(i * kPi / 3), std::sin(i * kPi / 3), i % 2 ? 0.007 : -0.007);
  for (int i = 0; i < 6; ++i) saddle.add_face({0, 1 + i, 1 + (i + 1) % 6});
  const Mesh mesh(saddle);
  const FoldableNet found = find_foldable_net(mesh, {.max_steps = 100});
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_TRUE(found.proven_impossible);
  EXPECT_TRUE(verify_net(lay_flat(mesh, found.tree), mesh).valid());
}

TEST(ClearTrees, NoNetOfTheSpikyCubeFoldsLinearlyButAPlannerFoldsOne) {
  const Mesh spiky = spiky_cube();
  const NetAndMotion found = fold_or_plan(spiky);
  EXPECT_TRUE(found.net.proven_impossible);
  EXPECT_EQ(found.net.ending, Ending::Exhausted);
  EXPECT_TRUE(verify_net(lay_flat(spiky, found.net.tree), spiky).is_net());
  ASSERT_TRUE(found.motion);
  EXPECT_EQ(found.motion->method, MotionMethod::LazyPrm);
  EXPECT_EQ(found.motion->proof.verdict, PathVerdict::Free);
}

TEST(ClearTrees, TooManyJointsAreRefused) {
  PanelKit kit;
  for (int i = 0; i < 66; ++i) {
    kit.outlines.push_back({{0, 0}, {1, 0}, {0, 1}});
    kit.twin.insert(kit.twin.end(), {i > 0 ? 3 * i - 2 : -1, i < 65 ? 3 * i + 3 : -1, -1});
    kit.first_side.push_back(3 * i + 3);
  }
  kit.fold_angle.assign(kit.twin.size(), 0);
  EXPECT_THROW(find_clear_trees(kit, {.clearance = 1e-3, .touch = 1e-6}, [](const std::vector<char>&) { return true; }),
               InvalidOption);
}

}  // namespace
}  // namespace plico
