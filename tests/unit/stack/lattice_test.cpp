#include "plico/stack/lattice.h"

#include <gtest/gtest.h>

namespace plico {
namespace {

Headings chain(const std::vector<int>& turns) {
  Headings headings{Heading::East};
  for (int turn : turns) headings.push_back(turned(headings.back(), turn));
  return headings;
}

Headings alternating(int panels, int first, int second) {
  std::vector<int> turns;
  for (int i = 0; i + 2 < panels; ++i) turns.push_back(i % 2 == 0 ? first : second);
  return chain(turns);
}

// All chains of so many panels, stacks added up.
long all_chains(int panels) {
  long total = 0, chains = 1;
  for (int i = 2; i < panels; ++i) chains *= 3;
  for (long code = 0; code < chains; ++code) {
    std::vector<int> turns;
    for (long c = code, i = 2; i < panels; ++i, c /= 3) turns.push_back(static_cast<int>(c % 3) - 1);
    total += count_stacks(chain(turns));
  }
  return total;
}

TEST(StackLattice, AStraightStripHasTheStacksOfTheOracle) {
  const long expected[] = {3, 7, 17, 37, 83, 181, 399, 863, 1887, 4057, 8797};
  for (int n = 2; n <= 12; ++n) EXPECT_EQ(count_stacks(alternating(n, 0, 0)), expected[n - 2]) << n;
}

TEST(StackLattice, AStripOfLeftTurnsHasTheStacksOfTheOracle) {
  const long expected[] = {7, 17, 36, 78, 164, 350, 706, 1456, 2910, 5932};
  for (int n = 3; n <= 12; ++n) EXPECT_EQ(count_stacks(alternating(n, 1, 1)), expected[n - 3]) << n;
}

TEST(StackLattice, AStaircaseHasTheStacksOfTheOracle) {
  const long expected[] = {7, 17, 41, 99, 239, 577, 1377, 3303, 7895, 18873};
  for (int n = 3; n <= 12; ++n) EXPECT_EQ(count_stacks(alternating(n, 1, -1)), expected[n - 3]) << n;
}

TEST(StackLattice, AllChainsTogetherHaveTheStacksOfTheOracle) {
  EXPECT_EQ(all_chains(5), 1069);
  EXPECT_EQ(all_chains(6), 7517);
  EXPECT_EQ(all_chains(7), 52155);
}

TEST(StackLattice, AlternatingFoldsMakeOnePile) {
  const Headings strip = alternating(6, 1, -1);
  std::vector<StackFold> folds;
  for (int i = 0; i < 5; ++i) folds.push_back(i % 2 == 0 ? StackFold::Valley : StackFold::Mountain);
  const std::vector<Slot> slots = stack_slots(strip, folds);
  EXPECT_TRUE(all_distinct(slots));
  EXPECT_EQ(box_of(slots), (StackBox{1, 1, 6}));
}

TEST(StackLattice, TheSameFoldTwiceComesBackToTheSlotItLeft) {
  const std::vector<Slot> slots = stack_slots(alternating(3, 0, 0), {StackFold::Valley, StackFold::Valley});
  EXPECT_EQ(slots[0], slots[2]);
  EXPECT_FALSE(all_distinct(slots));
}

TEST(StackLattice, AFoldMirrorsLaterFlatHingesOfItsOwnAxisOnly) {
  const Headings along = alternating(3, 0, 0), around = alternating(3, 1, 1);
  EXPECT_EQ(stack_slots(along, {StackFold::Valley, StackFold::Flat})[2], (Slot{-1, 0, 1}));
  EXPECT_EQ(stack_slots(around, {StackFold::Valley, StackFold::Flat})[2], (Slot{0, 1, 1}));
}

}  // namespace
}  // namespace plico
