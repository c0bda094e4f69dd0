#include "plico/motion/branch_sampler.h"

#include <gtest/gtest.h>

namespace plico {
namespace {

// Unit squares in a row, each joined to the next at its right side, all turning by `angle`.
PanelKit row_of_squares(int n, double angle) {
  PanelKit kit;
  for (int p = 0; p < n; ++p) {
    kit.outlines.push_back({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    kit.first_side.push_back(4 * (p + 1));
    const int before = p > 0 ? 4 * (p - 1) + 1 : -1, after = p + 1 < n ? 4 * (p + 1) + 3 : -1;
    kit.twin.insert(kit.twin.end(), {-1, after, -1, before});
    kit.fold_angle.insert(kit.fold_angle.end(), {0, angle, 0, angle});
  }
  return kit;
}

TEST(BranchSampler, ForgetsSamplesAndStillFindsConflictsAtNewOnes) {
  const PanelKit kit = row_of_squares(4, 1.7);  // the last square crosses the first just before the end
  BranchSampler sampler(kit, FoldingLaw::Linear, 1e-3, 1e-6);
  for (double time : {0.1, 0.2, 0.3, 0.4, 0.5}) sampler.add_sample(time);
  std::vector<char> joined(kit.twin.size());
  for (std::size_t side = 0; side < joined.size(); ++side) joined[side] = kit.twin[side] >= 0;
  sampler.reset(joined);
  EXPECT_TRUE(sampler.conflicts().empty());
  sampler.keep_samples(2);
  EXPECT_EQ(sampler.num_samples(), 2);
  sampler.add_sample(1);
  ASSERT_EQ(sampler.conflicts().size(), 1u);
  EXPECT_EQ(sampler.conflicts().front().sample, 2);
}

TEST(BranchSampler, KeepsAllSamplesWhenMoreMayStay) {
  const PanelKit kit = row_of_squares(2, 1);
  BranchSampler sampler(kit, FoldingLaw::Uniform, 1e-3, 1e-6);
  for (double time : {0.3, 0.6}) sampler.add_sample(time);
  sampler.keep_samples(5);
  EXPECT_EQ(sampler.num_samples(), 2);
}

}  // namespace
}  // namespace plico
