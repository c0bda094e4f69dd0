// The judge of chain motions against brute force: random chains in random stacks, some hinges turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "brute_chain.h"
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

// A chain whose hinges turn evenly.
struct ChainTurn {
  Headings headings;
  double thickness = 0.1;
  std::vector<double> from, to;

  ChainMotionVerdict judged() const {
    const auto config = [](const std::vector<double>& angles) {
      return Configuration(Eigen::Map<const Configuration>(angles.data(), static_cast<Eigen::Index>(angles.size())));
    };
    const Linkage chain = chain_linkage(headings, std::vector<double>(from.size(), 0), {1, thickness, thickness});
    return judge_chain_motion(chain, FoldingPath{{{0, config(from)}, {1, config(to)}}});
  }
  BruteChain brute() const { return {headings, thickness, ChainMotionOptions().air, from, to}; }
};

// Out of a stack of 3 to 12 panels, by one or two hinges.
ChainTurn turn_of_stack(Rng& rng) {
  const Sample sample = random_stack(rng, 3 + rng.below(10));
  ChainTurn motion{sample.headings, 0.02 + 0.2 * rng.uniform(), fold_angles(sample.folds), {}};
  motion.to = motion.from;
  const int turned = 1 + rng.below(2);
  for (int k = 0; k < turned; ++k)
    motion.to[rng.below(static_cast<int>(motion.to.size()))] = kPi * (2 * rng.uniform() - 1);
  return motion;
}

bool overlaps_at(BruteChain chain, double time, double grow) {
  chain.place_at(time);
  return chain.overlaps(grow);
}

bool overlaps_at_one_of(BruteChain chain, int moments, double grow) {
  for (int i = 0; i <= moments; ++i) {
    chain.place_at(static_cast<double>(i) / moments);
    if (chain.overlaps(grow)) return true;
  }
  return false;
}

constexpr double kRounding = 1e-9;
constexpr int kMoments = kSanitized ? 500 : 10000;

TEST(ChainMotion, AgreesWithBruteForceOnRandomChains) {
  Rng rng(11);
  int free = 0, collides = 0;
  for (int i = 0; i < num_cases(300); ++i) {
    SCOPED_TRACE(i);
    const ChainTurn motion = turn_of_stack(rng);
    const BruteChain brute = motion.brute();
    const ChainMotionVerdict verdict = motion.judged();
    if (verdict.verdict == PathVerdict::Free) {
      EXPECT_FALSE(overlaps_at_one_of(brute, kMoments, -kRounding));
      ++free;
    } else if (verdict.verdict == PathVerdict::Collides) {
      EXPECT_TRUE(overlaps_at(brute, verdict.from, kRounding));
      ++collides;
    } else {  // only where panels all but touch
      EXPECT_FALSE(overlaps_at_one_of(brute, kMoments, -1e-6));
    }
  }
  EXPECT_GT(free, num_cases(300) / 10);
  EXPECT_GT(collides, num_cases(300) / 10);
}

// From a random state to between two others, just so that panels brush each other on the way, for less time than there
// is between 25 samples; empty when there is no such state.
std::optional<ChainTurn> brushing(Rng& rng) {
  constexpr int kFew = 24;
  ChainTurn motion{Headings(4, Heading::East), 0.1, std::vector<double>(4), {}};
  std::vector<double> free(4), other(4);
  for (int h = 0; h < 4; ++h) {
    if (h > 0) motion.headings[h] = turned(motion.headings[h - 1], rng.below(3) - 1);
    for (std::vector<double>* angles : {&motion.from, &free, &other}) (*angles)[h] = kPi * (2 * rng.uniform() - 1);
  }
  const auto overlaps = [&](const std::vector<double>& to, int moments) {
    motion.to = to;
    return overlaps_at_one_of(motion.brute(), moments, -kRounding);
  };
  if (overlaps(free, kFew) || !overlaps(other, kFew)) return {};
  for (int i = 0; i < 30; ++i) {
    std::vector<double> middle(4);
    for (int h = 0; h < 4; ++h) middle[h] = (free[h] + other[h]) / 2;
    if (overlaps(middle, kFew))
      other = middle;
    else if (overlaps(middle, 500))
      return motion;
    else
      free = middle;
  }
  return {};
}

TEST(ChainMotion, FindsACollisionBetweenSamples) {
  Rng rng(5);
  for (int planted = 0; planted < num_cases(20);) {
    const std::optional<ChainTurn> motion = brushing(rng);
    if (!motion) continue;
    SCOPED_TRACE(++planted);
    const ChainMotionVerdict verdict = motion->judged();
    ASSERT_EQ(verdict.verdict, PathVerdict::Collides);
    EXPECT_TRUE(overlaps_at(motion->brute(), verdict.from, kRounding));
  }
}

}  // namespace
}  // namespace plico
