// Sheets with slits and holes: closed forms that hold along a whole motion, and what the planner makes of them.
#include "plico/origami/kirigami.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/base/error.h"
#include "plico/motion/collision.h"
#include "plico/origami/closure.h"
#include "plico/origami/continuation.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

struct Loops {
  int vertices = 0, holes = 0;
  std::size_t least = 1000, most = 0;  // creases around a hole
};

Loops loops_of(const CreasePattern& sheet) {
  Loops loops;
  for (const RealVertex& loop : real_vertices(sheet)) {
    if (!loop.is_hole()) {
      ++loops.vertices;
      continue;
    }
    ++loops.holes;
    loops.least = std::min(loops.least, loop.hinges.size());
    loops.most = std::max(loops.most, loop.hinges.size());
  }
  return loops;
}

double opening(const CreasePattern& sheet, const Configuration& config) {
  return closure(real_vertices(sheet), config).worst;
}

// By the projections of the loops, then by the proof, which places the panels itself.
void expect_folds_whole(const CreasePattern& sheet) {
  const Linkage linkage = make_linkage(sheet);
  const ContinuationResult found = continue_to_goal(sheet);
  ASSERT_EQ(found.ending, Ending::Found) << name(found.obstacle);
  const PathProof proof = prove_path(linkage, found.path);
  EXPECT_EQ(proof.verdict, PathVerdict::Free) << proof.panel_a << " " << proof.panel_b << " at " << proof.from;
  EXPECT_GT(proof.loops.loops, 0);
  EXPECT_LT(proof.loops.residual, 1e-9);
}

TEST(Honeycomb, HasALoopOfTenCreasesAroundEverySlitInside) {
  const CreasePattern sheet = honeycomb({.columns = 3, .rows = 4});
  const Loops loops = loops_of(sheet);
  EXPECT_EQ(sheet.num_faces(), 4 * 13);
  EXPECT_EQ(loops.vertices, 0);
  EXPECT_EQ(loops.holes, 3 + 2 + 3);  // between the top walls, the bottom walls, the top walls
  EXPECT_EQ(loops.least, 10U);
  EXPECT_EQ(loops.most, 10U);
}

TEST(Honeycomb, ClosesForEveryChoiceOfItsTwoAngles) {
  for (const double wall : {0.0, 0.4, radians(60), kPi / 2})
    for (const double strip : {0.0, 1.0, kPi}) {
      const CreasePattern sheet = honeycomb({.wall_angle = wall, .strip_angle = strip});
      EXPECT_LT(opening(sheet, goal(make_linkage(sheet))), 1e-12) << wall << " " << strip;
    }
}

TEST(Honeycomb, FoldsToItsHexagons) { expect_folds_whole(honeycomb({.columns = 2, .rows = 3})); }

TEST(RotatingSquares, HaveALoopOfTwelveCreasesAroundEveryHole) {
  const CreasePattern sheet = rotating_squares({.columns = 5, .rows = 5});
  const Loops loops = loops_of(sheet);
  EXPECT_EQ(sheet.num_faces(), 13 + 2 * 16);  // black squares, two triangles a corner inside
  EXPECT_EQ(make_linkage(sheet).num_hinges(), 3 * 16);
  EXPECT_EQ(loops.vertices, 0);
  EXPECT_EQ(loops.holes, 4);
  EXPECT_EQ(loops.least, 12U);
  EXPECT_EQ(loops.most, 12U);
}

TEST(RotatingSquares, CloseAtEveryAngleOfTheirGussets) {
  for (const double middle : {0.0, 0.5, 1.5, 3.0, kPi}) {
    const CreasePattern sheet = rotating_squares({.columns = 6, .rows = 4, .middle_angle = middle});
    EXPECT_LT(opening(sheet, goal(make_linkage(sheet))), 1e-12) << middle;
  }
}

TEST(PopUp, HasALoopOfFourCreasesAroundEverySlit) {
  const Loops loops = loops_of(pop_up());
  EXPECT_EQ(loops.vertices, 0);
  EXPECT_EQ(loops.holes, 6);
  EXPECT_EQ(loops.least, 4U);
  EXPECT_EQ(loops.most, 4U);
}

TEST(PopUp, ClosesAtEveryAngleAndFoldsShut) {
  for (const double angle : {0.3, kPi / 2, 3.0})
    EXPECT_LT(opening(pop_up(angle), goal(make_linkage(pop_up(angle)))), 1e-12);
  expect_folds_whole(pop_up());
}

TEST(Kirigami, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(honeycomb({.columns = 0}), InvalidOption);
  EXPECT_THROW(honeycomb({.rows = 0}), InvalidOption);
  EXPECT_THROW(honeycomb({.wall_angle = 2}), InvalidOption);
  EXPECT_THROW(honeycomb({.strip_angle = 4}), InvalidOption);
  EXPECT_THROW(honeycomb({.height = 0}), InvalidOption);
  EXPECT_THROW(rotating_squares({.columns = 1}), InvalidOption);
  EXPECT_THROW(rotating_squares({.rows = 1}), InvalidOption);
  EXPECT_THROW(rotating_squares({.middle_angle = -1}), InvalidOption);
  EXPECT_THROW(rotating_squares({.gusset = 0}), InvalidOption);
  EXPECT_THROW(pop_up(4), InvalidOption);
}

}  // namespace
}  // namespace plico
