// The judge of chain motions against brute force: random chains in random stacks, some hinges turned.
#include <gtest/gtest.h>

#include <algorithm>

#include "effort.h"
#include "plico/base/rng.h"
#include "plico/geom/oriented_box.h"
#include "plico/stack/chain_linkage.h"
#include "plico/stack/lattice.h"
#include "plico/verify/chain_motion.h"
#include "plico/verify/separation.h"

namespace plico {
namespace {

OrientedBox random_box(Rng& rng) {
  const Vec3 axis = Vec3(rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5).normalized();
  OrientedBox box;
  box.axes = rotation(axis, 6 * rng.uniform());
  box.center = Vec3(rng.uniform(), rng.uniform(), rng.uniform()) * 2;
  box.half = Vec3(0.05 + 0.4 * rng.uniform(), 0.05 + 0.4 * rng.uniform(), 0.01 + 0.4 * rng.uniform());
  return box;
}

// One end, then the other, each in cyclic order.
std::array<Vec3, 8> prism(const OrientedBox& box) {
  const std::array<Vec3, 8> c = corners_of(box);
  return {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]};
}

TEST(BoxGap, AgreesWithTheSeparationOfPrisms) {
  Rng rng(3);
  int apart = 0;
  for (int i = 0; i < num_cases(20000); ++i) {
    const OrientedBox a = random_box(rng), b = random_box(rng);
    const double wide = gap(a, b), oracle = separation_of_prisms(prism(a), prism(b)).value;
    EXPECT_NEAR(wide, oracle, 1e-9);
    EXPECT_NEAR(gap(b, a), wide, 1e-9);
    apart += wide > 0;
  }
  EXPECT_GT(apart, num_cases(2000));
}

struct Sample {
  Headings headings;
  std::vector<StackFold> folds;
};

// A walk through slots of its own.
Sample random_stack(Rng& rng, int panels) {
  for (;;) {
    Sample sample;
    for (int h = 0; h + 1 < panels; ++h) {
      const int left = rng.below(3) - 1;
      sample.headings.push_back(h == 0 ? Heading::East : turned(sample.headings.back(), left));
      sample.folds.push_back(static_cast<StackFold>(rng.below(3) - 1));
    }
    if (all_distinct(stack_slots(sample.headings, sample.folds))) return sample;
  }
}

// The panels shrunk as the judge does.
std::vector<OrientedBox> boxes(const Linkage& chain, const Configuration& config, double air) {
  const std::vector<Pose> poses = folding_map(chain, config);
  std::vector<OrientedBox> all;
  for (int p = 0; p < chain.num_panels(); ++p) {
    const std::vector<Vec3>& o = chain.panels[p];
    const OrientedBox flat{(o[0] + o[2]) / 2,
                           Eigen::Matrix3d::Identity(),
                           {(o[1] - o[0]).norm() / 2, (o[1] - o[0]).norm() / 2, (0.5 - air) * chain.thickness}};
    all.push_back(placed(flat, poses[p]));
  }
  return all;
}

// The deepest overlap of two panels that are no mates, at so many moments; negative when all stay apart.
double deepest(const Linkage& chain, const FoldingPath& path, double air, int moments) {
  double worst = -1;
  for (int i = 0; i <= moments; ++i) {
    const std::vector<OrientedBox> at = boxes(chain, path.at(static_cast<double>(i) / moments), air);
    for (std::size_t a = 0; a < at.size(); ++a)
      for (std::size_t b = a + 2; b < at.size(); ++b) worst = std::max(worst, -gap(at[a], at[b]));
  }
  return worst;
}

TEST(ChainMotion, AgreesWithBruteForceOnRandomChains) {
  Rng rng(11);
  int free = 0, collides = 0;
  for (int i = 0; i < num_cases(300); ++i) {
    const int panels = 3 + rng.below(10);
    const Sample sample = random_stack(rng, panels);
    const double thickness = 0.02 + 0.2 * rng.uniform();
    const std::vector<double> shape(sample.headings.size(), 0.0);
    const Linkage chain = chain_linkage(sample.headings, shape, {1, thickness, thickness});
    FoldingPath path;
    const std::vector<double> angles = fold_angles(sample.folds);
    Configuration config = Eigen::Map<const Configuration>(angles.data(), static_cast<Eigen::Index>(angles.size()));
    path.waypoints.push_back({0, config});
    const int turned = 1 + rng.below(2);
    for (int k = 0; k < turned; ++k) config[rng.below(static_cast<int>(angles.size()))] = kPi * (2 * rng.uniform() - 1);
    path.waypoints.push_back({1, config});
    const ChainMotionVerdict verdict = judge_chain_motion(chain, path);
    const double depth = deepest(chain, path, ChainMotionOptions().air, kSanitized ? 500 : 10000);
    if (verdict.verdict == PathVerdict::Free) {
      EXPECT_LT(depth, 0) << "case " << i;
      ++free;
    } else if (verdict.verdict == PathVerdict::Collides) {
      const std::vector<OrientedBox> at = boxes(chain, path.at(verdict.from), ChainMotionOptions().air);
      double wide = 1;
      for (std::size_t a = 0; a < at.size(); ++a)
        for (std::size_t b = a + 2; b < at.size(); ++b) wide = std::min(wide, gap(at[a], at[b]));
      EXPECT_LT(wide, 1e-9) << "case " << i;
      ++collides;
    } else {
      EXPECT_GT(depth, -1e-6) << "case " << i;  // undecided only where panels all but touch
    }
  }
  EXPECT_GT(free, num_cases(300) / 10);
  EXPECT_GT(collides, num_cases(300) / 10);
}

}  // namespace
}  // namespace plico
