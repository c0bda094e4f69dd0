#include "plico/origami/discrete_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "plico/base/error.h"
#include "plico/motion/collision.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

std::size_t count(const CreasePattern& sheet, AngleSet angles, const std::vector<int>& groups = {}) {
  return discrete_states(sheet, {.angles = angles, .groups = groups}).states.size();
}

TEST(Discrete, CountsOfTable32ComeOut) {
  EXPECT_EQ(count(l2(), AngleSet::Discrete3), 5);
  EXPECT_EQ(count(l2(), AngleSet::Discrete4), 6);
  EXPECT_EQ(count(waterbomb_base(), AngleSet::Discrete3), 71);
  EXPECT_EQ(count(waterbomb_base(), AngleSet::Discrete4), 114);
  EXPECT_EQ(count(miura(), AngleSet::Discrete3), 7);
  EXPECT_EQ(count(miura(), AngleSet::Discrete4), 7);
}

TEST(Discrete, GroupedCountsOfTable32ComeOut) {
  const std::vector<int> axes_and_diagonals = {0, 1, 0, 1, 0, 1, 0, 1};
  EXPECT_EQ(count(waterbomb_base(), AngleSet::Discrete3, axes_and_diagonals), 5);
  EXPECT_EQ(count(waterbomb_base(), AngleSet::Discrete4, axes_and_diagonals), 6);
  const std::vector<int> zigzag_and_straight = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(count(miura(), AngleSet::Discrete3, zigzag_and_straight), 3);
  EXPECT_EQ(count(miura(), AngleSet::Discrete4, zigzag_and_straight), 3);
}

// Mirror images, both fins, and the four flaps at the border fold alike.
std::vector<int> sailboat_groups() {
  constexpr std::array<int, 12> kMerged = {0, 1, 0, 0, 0, 2, 3, 4, 5, 5, 5, 5};
  std::vector<int> groups = groups_of(discrete_states(sailboat()).states);
  for (int& group : groups) group = kMerged[group];
  return groups;
}

TEST(Discrete, SailboatStatesFindTwelveTrajectories) {
  const std::vector<int> groups = groups_of(discrete_states(sailboat()).states);
  EXPECT_EQ(*std::max_element(groups.begin(), groups.end()), 11);
}

// Table 3.2 has 118 for Discrete4. By closure there are 147 and none of them has panels that penetrate, so 118 must
// come from a rule for panels in contact that the text does not give.
TEST(Discrete, SailboatGroupedCountsOfTable32) {
  EXPECT_EQ(count(sailboat(), AngleSet::Discrete3, sailboat_groups()), 48);
  const DiscreteStates four = discrete_states(sailboat(), {.angles = AngleSet::Discrete4, .groups = sailboat_groups()});
  EXPECT_EQ(four.states.size(), 147);
  const Linkage linkage = make_linkage(sailboat());
  CollisionChecker checker(linkage);
  for (const Configuration& state : four.states) EXPECT_FALSE(checker.collides(state));
}

TEST(Discrete, RandomSamplesFindTheSameStates) {
  const auto sampled = sample_discrete_states(make_linkage(l2()), {.angles = AngleSet::Discrete4}, 20000);
  auto all = discrete_states(l2(), {.angles = AngleSet::Discrete4}).states;
  ASSERT_EQ(sampled.states.size(), all.size());
  EXPECT_TRUE(sampled.states.front().isZero());
  for (const Configuration& state : sampled.states) EXPECT_NE(std::find(all.begin(), all.end(), state), all.end());
}

TEST(Discrete, MaterialLimitsClampTheSets) {
  EXPECT_EQ(important_angles(-radians(120), AngleSet::Discrete4, radians(90)), (std::vector<double>{0, -radians(90)}));
  EXPECT_EQ(important_angles(radians(120), AngleSet::Discrete4), (std::vector<double>{0, kPi / 2, kPi, radians(120)}));
  EXPECT_EQ(important_angles(0, AngleSet::Discrete4), (std::vector<double>{0}));
}

TEST(Discrete, GroupsMustFit) {
  EXPECT_THROW(discrete_states(l2(), {.groups = {0, 1}}), InvalidInput);
  EXPECT_THROW(discrete_states(l2(), {.groups = {0, 0, 0, 0}}), InvalidInput);  // targets of 180 and 90 degrees
  EXPECT_THROW(discrete_states(l2(), {.groups = {0, 2, 0, 2}}), InvalidInput);
}

TEST(Discrete, StopsAtTheNumberAskedFor) {
  const DiscreteStates some = discrete_states(waterbomb_base(), {}, 10);
  EXPECT_EQ(some.states.size(), 10);
  EXPECT_EQ(some.ending, Ending::Exhausted);
}

}  // namespace
}  // namespace plico
