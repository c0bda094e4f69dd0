#include "plico/verify/chain_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plico/base/error.h"
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

// The ball's motion stretched by waypoints on the way until it is too long for frames.
StackMotion long_motion() {
  StackMotion motion = ball();
  FoldingPath path;
  const long panels = static_cast<long>(motion.chain.claim.stack.size()) + 1, count = kMostFramedPanels / panels + 2;
  for (long i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / static_cast<double>(count - 1);
    path.waypoints.push_back({time, motion.path.at(time)});
  }
  motion.path = path;
  return motion;
}

TEST(ChainMotionFile, ALongMotionIsToldByWhatTurns) {
  const StackMotion motion = long_motion();
  const FoldFile told = chain_motion_file(motion);
  EXPECT_FALSE(told.path);
  FoldFile file = read_fold(write_fold(told), "ball.fold");
  take_told_motion(file, motion.chain.claim);
  ASSERT_TRUE(file.path);
  ASSERT_EQ(file.path->waypoints.size(), motion.path.waypoints.size());
  for (std::size_t i = 0; i < motion.path.waypoints.size(); i += 50) {
    EXPECT_EQ(file.path->waypoints[i].time, motion.path.waypoints[i].time);
    EXPECT_LT((file.path->waypoints[i].config - motion.path.waypoints[i].config).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(ChainMotionFile, AToldMotionThatIsBrokenIsRefused) {
  const ChainClaim claim = ball().chain.claim;
  for (const char* told :
       {R"({"times": [0, 1]})", R"({"times": [0, 1], "turns_deg": [[]]})",
        R"({"times": [0, 1], "turns_deg": [[0], []]})", R"({"times": [0, 1], "turns_deg": [3, []]})",
        R"({"times": [0, 1], "turns_deg": [[-1, 90], []]})", R"({"times": [0, 1], "turns_deg": [[100000, 90], []]})",
        R"({"times": [0, 0], "turns_deg": [[0, 90], []]})", R"({"times": [0, 0.5], "turns_deg": [[0, 90], []]})",
        R"({"times": 3, "turns_deg": [[]]})"}) {
    FoldFile file = chain_file(claim);
    file.other.emplace_back("plico:chain_motion", told);
    EXPECT_THROW(take_told_motion(file, claim), InvalidInput) << told;
  }
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
