#include "plico/verify/chain_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plico/shapes/named_shapes.h"
#include "plico/workflow/stack_motion.h"

namespace plico {
namespace {

// A small ball of voxels, stacked and unpacked.
const StackMotion& ball() {
  static const StackMotion motion = [] {
    const VoxelMesh voxels = voxel_mesh(make_shape("icosahedron"), {.cells = 4});
    const JudgedCycle cycle = judged_cycle(voxels, {});
    const StackMeshOptions stacking{.thickness = 0.02, .width = 2, .depth = 2};
    return unpack_stack(voxels, stack_voxels(voxels, cycle.found.cycle, stacking), stacking);
  }();
  return motion;
}

ChainMotionVerdict judged(const FoldingPath& path) { return judge_chain_motion(ball().chain.claim, path); }

TEST(ChainMotion, FromTheStackToTheShapeIsProven) {
  ASSERT_EQ(ball().ending, Ending::Found);
  EXPECT_TRUE(ball().verdict.free());
  EXPECT_EQ(ball().share(), 1);
  EXPECT_EQ(ball().path.waypoints.back().config, goal(chain_linkage_of(ball().chain.claim)));
}

TEST(ChainMotion, AWrongSignIsFound) {
  FoldingPath path = ball().path;
  for (Waypoint& waypoint : path.waypoints) waypoint.config[5] = -waypoint.config[5];
  EXPECT_FALSE(judged(path).free());
}

TEST(ChainMotion, ASlotUsedTwiceIsFound) {
  ChainClaim claim = ball().chain.claim;
  claim.stack[4] = -claim.stack[4];
  EXPECT_FALSE(verify_chain(claim).valid());
}

TEST(ChainMotion, ACollisionBetweenTwoStatesThatAreFreeIsFound) {
  // From the pile straight to the shape: both ends are free, the way is not.
  FoldingPath path;
  path.waypoints = {ball().path.waypoints.front(), ball().path.waypoints.back()};
  const ChainMotionVerdict verdict = judged(path);
  EXPECT_EQ(verdict.verdict, PathVerdict::Collides);
  EXPECT_GT(verdict.from, 0);
  EXPECT_LT(verdict.from, 1);
}

TEST(ChainMotion, ItMustBeginInTheStackAndKeepToHalfATurn) {
  FoldingPath path = ball().path;
  path.waypoints.erase(path.waypoints.begin());
  path.waypoints.front().time = 0;
  EXPECT_THAT(judged(path).defects, testing::Not(testing::IsEmpty()));
  path = ball().path;
  path.waypoints[2].config[0] = 1.5 * kPi;
  EXPECT_FALSE(judged(path).free());
}

TEST(ChainMotion, AMotionThatIsCutShortSaysHowFarItGoes) {
  FoldingPath path = ball().path;
  path.waypoints.resize(path.waypoints.size() / 2);
  path.waypoints.back().time = 1;
  for (std::size_t i = 0; i + 1 < path.waypoints.size(); ++i)
    path.waypoints[i].time = static_cast<double>(i) / static_cast<double>(path.waypoints.size());
  const ChainMotionVerdict verdict = judged(path);
  EXPECT_EQ(verdict.verdict, PathVerdict::Free);
  EXPECT_THAT(verdict.defects, testing::Not(testing::IsEmpty()));  // nobody said that it ends there
  ChainClaim claim = ball().chain.claim;
  claim.opened = verdict.opened;
  EXPECT_LT(claim.opened, path.waypoints[0].config.size());
  EXPECT_TRUE(judge_chain_motion(claim, path).free());
}

TEST(UnpackStack, TheSameSeedGivesTheSameMotion) {
  const VoxelMesh voxels = voxel_mesh(make_shape("icosahedron"), {.cells = 4});
  const JudgedCycle cycle = judged_cycle(voxels, {});
  const StackMeshOptions stacking{.thickness = 0.02, .width = 2, .depth = 2};
  const StackMotion again = unpack_stack(voxels, stack_voxels(voxels, cycle.found.cycle, stacking), stacking);
  EXPECT_EQ(write_fold(chain_motion_file(again)), write_fold(chain_motion_file(ball())));
}

TEST(UnpackStack, IntoAPileOnlySwings) {
  const VoxelMesh voxels = voxel_mesh(make_shape("icosahedron"), {.cells = 4});
  const JudgedCycle cycle = judged_cycle(voxels, {});
  const StackMeshOptions stacking{.thickness = 0.1, .width = 2, .depth = 2};
  const StackedChain stacked = stack_voxels(voxels, cycle.found.cycle, stacking);
  const StackMotion motion = unpack_stack(voxels, stacked, stacking, {.to_shape = false});
  EXPECT_EQ(motion.ending, Ending::Found);
  EXPECT_TRUE(motion.verdict.free());
  EXPECT_EQ(motion.path.waypoints.size(), 4u);  // three flat hinges
}

}  // namespace
}  // namespace plico
