#include "plico/fold/plain_hinges.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

Linkage thick_strip(int base, double thickness) {
  return thick_hinged(make_linkage(square_strip({1, -1, kPi, -kPi, 0.5}), {}, base), thickness, thickness);
}

Configuration random_angles(const Linkage& linkage, Rng& rng) {
  Configuration config(linkage.num_hinges());
  for (double& angle : config) angle = (2 * rng.uniform() - 1) * kPi;
  return config;
}

void expect_same_panels(const Linkage& thick, const Linkage& plain, const Configuration& config,
                        const Configuration& plain_config) {
  const std::vector<Pose> poses = folding_map(thick, config), again = folding_map(plain, plain_config);
  for (int p = 0; p < thick.num_panels(); ++p)
    EXPECT_LT((poses[p].matrix() - again[p].matrix()).cwiseAbs().maxCoeff(), 1e-12) << p;
}

TEST(PlainHinges, CarryPanelsAsThickOnesDo) {
  Rng rng(1);
  for (int base : {0, 3, 5})  // hinges turn their right panels, their left ones, and both kinds
    for (double thickness : {0.01, 0.2}) {
      const Linkage thick = thick_strip(base, thickness), plain = plain_hinged(thick);
      EXPECT_FALSE(has_thick_hinges(plain));
      EXPECT_EQ(plain.num_hinges(), 3 * thick.num_hinges());
      EXPECT_EQ(plain.num_panels(), thick.num_panels() + 2 * thick.num_hinges());
      for (int trial = 0; trial < 50; ++trial) {
        const Configuration config = random_angles(thick, rng);
        expect_same_panels(thick, plain, config, plain_angles(config));
        EXPECT_EQ(hinge_beyond_limits(plain, plain_angles(config)), -1);
      }
      expect_same_panels(thick, plain, goal(thick), goal(plain));
    }
}

TEST(PlainHinges, MoveStraightBetweenTheWaypointsOfTheirPath) {
  Rng rng(2);
  const Linkage thick = thick_strip(0, 0.1), plain = plain_hinged(thick);
  FoldingPath path;
  for (int k = 0; k < 5; ++k) {
    const Configuration config = random_angles(thick, rng);
    path.waypoints.push_back({k / 4.0, config});
  }
  const FoldingPath again = plain_path(path);
  EXPECT_GT(again.waypoints.size(), path.waypoints.size());
  for (double time = 0; time <= 1; time += 1.0 / 64) expect_same_panels(thick, plain, path.at(time), again.at(time));
}

TEST(PlainHinges, AreOneStraightTurnWithinAQuarter) {
  const Linkage thick = thick_strip(0, 0.1);
  FoldingPath path;
  path.waypoints = {{0, flat(thick)}, {1, Configuration::Constant(thick.num_hinges(), kPi / 2)}};
  EXPECT_EQ(plain_path(path).waypoints.size(), 2u);
}

}  // namespace
}  // namespace plico
