#include "plico/stack/pile_fit.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

Headings random_chain(int panels, std::uint64_t seed) {
  Rng rng(seed);
  Headings headings{Heading::East};
  while (static_cast<int>(headings.size()) + 1 < panels) headings.push_back(turned(headings.back(), rng.below(3) - 1));
  return headings;
}

PileReach look(PileFit& fit, const Headings& headings) {
  std::vector<Heading> letters;
  alternate(headings, letters);
  return fit.look(letters);
}

TEST(PileFit, WhatFitsIsAStackInsideTheBlock) {
  int fitting = 0;
  for (int seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const Headings chain = random_chain(30, seed);
    PileFit fit(snake(3, 2, seed % 8), 7, 30);
    if (!look(fit, chain).fits) continue;
    ++fitting;
    const std::vector<Slot> slots = stack_slots(chain, fit.folds());
    EXPECT_TRUE(all_distinct(slots));
    const StackBox box = box_of(slots);
    EXPECT_LE(box.width, 3);
    EXPECT_LE(box.depth, 2);
    EXPECT_LE(box.height, 7);
  }
  EXPECT_GT(fitting, 20);
}

// Brute force over where each pile ends; layers are checked by the walk.
bool fits_by_trying(const Headings& chain, const std::vector<Heading>& steps, int height, std::size_t hinge,
                    const StackWalk& walk, std::size_t pile, bool up) {
  if (hinge == chain.size()) return true;
  StackWalk on = walk;
  on.pass(chain[hinge], up == walk.front_up() ? StackFold::Valley : StackFold::Mountain);
  const int layer = on.slot().layer;
  if (layer >= 0 && layer < height && fits_by_trying(chain, steps, height, hinge + 1, on, pile, up)) return true;
  if (pile == steps.size() || walk.flat_direction(chain[hinge]) != steps[pile]) return false;
  StackWalk over = walk;
  over.pass(chain[hinge], StackFold::Flat);
  return fits_by_trying(chain, steps, height, hinge + 1, over, pile + 1, !up);
}

TEST(PileFit, FindsAStackExactlyWhenTryingAllFindsOne) {
  int fitting = 0;
  for (int seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE(seed);
    const Headings chain = random_chain(15, seed);
    const std::vector<Heading> steps = snake(2, 2, seed % 8);
    PileFit fit(steps, 4 + seed % 2, 15);
    const bool expected = fits_by_trying(chain, steps, fit.height(), 0, {}, 0, true);
    EXPECT_EQ(look(fit, chain).fits, expected);
    fitting += expected ? 1 : 0;
  }
  EXPECT_GT(fitting, 30);
}

TEST(PileFit, KeepsWhatIsKnownOfAnUnchangedBeginning) {
  Headings chain = random_chain(60, 5);
  std::vector<Heading> letters;
  alternate(chain, letters);
  PileFit kept(snake(3, 3, 0), 8, 60);
  kept.look(letters);
  Rng rng(7);
  for (int change = 0; change < 200; ++change) {
    const int from = rng.below(59);
    for (int i = from; i < 59; ++i) chain[i] = turned(chain[i], rng.below(4));
    letters.resize(from);
    alternate(chain, letters);
    PileFit fresh(snake(3, 3, 0), 8, 60);
    EXPECT_EQ(kept.look(letters, from), fresh.look(letters)) << change;
  }
}

TEST(PileFit, RefusesABlockWithFewerSlotsThanPanels) {
  EXPECT_THROW(PileFit(snake(2, 2, 0), 3, 13), InvalidInput);
  EXPECT_NO_THROW(PileFit(snake(2, 2, 0), 3, 12));
}

TEST(PileFit, ASnakeVisitsEveryCellOnce) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    std::vector<Slot> cells{{}};
    for (Heading step : snake(4, 3, symmetry)) {
      Slot next = cells.back();
      (along_x(step) ? next.x : next.y) += index(step) < 2 ? 1 : -1;
      cells.push_back(next);
    }
    EXPECT_TRUE(all_distinct(cells));
    EXPECT_EQ(box_of(cells), (StackBox{4, 3, 1})) << symmetry;
  }
}

}  // namespace
}  // namespace plico
