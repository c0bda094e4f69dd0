#include "plico/origami/crease_groups.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/closure.h"
#include "plico/origami/continuation.h"
#include "plico/origami/patterns.h"
#include "plico/origami/reuse.h"

namespace plico {
namespace {

CreasePattern miura_of(int size, bool diagonals = false) {
  return miura({.columns = size, .rows = size, .zigzag_angle = radians(120), .facet_diagonals = diagonals});
}

CreasePattern waterbomb_of(int columns, int rows, bool horizontals = false) {
  return waterbomb({columns, rows, radians(40), horizontals});
}

// Tables 3.2 and 3.3: groups are the degrees of freedom with symmetry.
TEST(CreaseGroups, AreThoseOfTable33) {
  for (const CreasePattern& sheet : {miura_of(3), miura_of(5), miura_of(24, true), miura()}) {
    const CreaseGroups groups = crease_groups(sheet);
    EXPECT_EQ(groups.num_moving, 2);
    EXPECT_EQ(groups.essential.size(), 1);
    EXPECT_EQ(covering_vertices(make_linkage(sheet), groups).size(), 1);
  }
  for (const CreasePattern& sheet : {waterbomb_of(4, 6), waterbomb_of(8, 10), waterbomb_of(12, 22, true)}) {
    const CreaseGroups groups = crease_groups(sheet);
    EXPECT_EQ(groups.num_moving, 4);
    EXPECT_EQ(groups.essential.size(), 3);
    EXPECT_EQ(covering_vertices(make_linkage(sheet), groups).size(), 1);  // the table's 3 is one of each type
  }
}

TEST(CreaseGroups, OfBases) {
  EXPECT_EQ(crease_groups(waterbomb_base()).num_moving, 2);
  EXPECT_EQ(crease_groups(l2()).num_moving, 3);  // no symmetry takes one half of the second line to the other
}

// Found from the pattern alone, and from a motion that knows nothing of groups. (A waterbomb has more ways to fold than
// the symmetric one.)
TEST(CreaseGroups, AreThoseOfASolvedMotion) {
  const CreasePattern sheet = miura_of(5);
  const ContinuationResult solved = continue_to_goal(sheet, {.frames = 20});
  ASSERT_EQ(solved.ending, Ending::Found);
  EXPECT_EQ(crease_groups(sheet).group, groups_along(solved.path));
}

TEST(CreaseGroups, PlanningInGroupsIsPlanningInAll) {
  for (const CreasePattern& sheet : {miura_of(5), waterbomb_of(8, 10)}) {
    const CreaseGroups groups = crease_groups(sheet);
    const ContinuationResult few =
        continue_to_goal(sheet, {.frames = 20, .groups = groups.group, .essential = groups.essential});
    ASSERT_EQ(few.ending, Ending::Found);
    EXPECT_TRUE(check_waypoints(sheet, few.path).valid());
  }
}

TEST(Reuse, SmallPatternsFoldLargeOnes) {
  const std::vector<std::pair<CreasePattern, CreasePattern>> pairs = {{miura_of(3), miura_of(12, true)},
                                                                      {waterbomb_of(4, 6), waterbomb_of(12, 10, true)}};
  for (const auto& [small, large] : pairs) {
    const CreaseGroups groups = crease_groups(small);
    const ContinuationResult solved =
        continue_to_goal(small, {.frames = 20, .groups = groups.group, .essential = groups.essential});
    ASSERT_EQ(solved.ending, Ending::Found);
    const FoldingPath reused = reuse_path(small, solved.path, large);
    const WaypointCheck check = check_waypoints(large, reused);
    EXPECT_TRUE(check.valid()) << check.worst_residual;
    EXPECT_LT((reused.waypoints.back().config - goal(make_linkage(large))).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Reuse, RefusesAPatternOfAnotherKind) {
  const ContinuationResult solved = continue_to_goal(miura_of(3), {.frames = 5});
  EXPECT_THROW(reuse_path(miura_of(3), solved.path, waterbomb_of(4, 6)), InvalidInput);
}

TEST(Reuse, CheckFindsWhatIsOpenAndWhatCollides) {
  const CreasePattern sheet = waterbomb_of(4, 6);
  FoldingPath path = continue_to_goal(sheet, {.frames = 4}).path;
  path.waypoints[2].config[0] += 0.1;
  EXPECT_GT(check_waypoints(sheet, path).worst_residual, 1e-3);
  const CreasePattern tube = waterbomb({12, 6, radians(70)});  // beyond 49.28 degrees its ends run into each other
  const WaypointCheck check = check_waypoints(tube, linear_path(make_linkage(tube)));
  EXPECT_EQ(check.waypoint, 1);
}

}  // namespace
}  // namespace plico
