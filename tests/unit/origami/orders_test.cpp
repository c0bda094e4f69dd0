#include "plico/origami/orders.h"

#include <gtest/gtest.h>

#include <array>

#include "plico/fold/planar_faces.h"
#include "plico/origami/facets.h"

namespace plico {
namespace {

// The corner of a bird base opened and sunk: a square within a square, its diagonals, and the line that halves both.
// Cut by its longest diagonals it can move.
Linkage open_sink() {
  CreasePattern sheet;
  for (const auto& [x, y] : std::array<std::array<double, 2>, 13>{
           {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {1, 1}, {2, 1}, {3, 1}, {3, 3}, {2, 3}, {1, 3}, {2, 2}}})
    sheet.vertices.emplace_back(x, y);
  for (int v = 0; v < 6; ++v) sheet.edges.push_back({v, (v + 1) % 6, Assignment::Boundary, 0});
  const auto mountains = {std::pair(0, 6), {2, 8},  {3, 9},   {5, 11}, {6, 7},  {7, 8},
                          {8, 9},          {9, 10}, {10, 11}, {11, 6}, {7, 12}, {12, 10}};
  for (const auto& [a, b] : mountains) sheet.edges.push_back({a, b, Assignment::Mountain, -kPi});
  for (const auto& [a, b] : {std::pair(1, 7), {4, 10}, {6, 12}, {8, 12}, {9, 12}, {11, 12}})
    sheet.edges.push_back({a, b, Assignment::Valley, kPi});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return make_linkage(cut_into_facets(sheet, CutChoice::Long).sheet);
}

TEST(Orders, OneOfThirtyLeadsOnWhereTheStraightWayEnds) {
  const Linkage linkage = open_sink();
  const ContinuationResult straight = approach_goal(linkage, {});
  ASSERT_GT(straight.path.waypoints.size(), 1u);
  ASSERT_LT(straight.progress, 0.98);
  bool arrives = false;
  for (int i = 0; i < 30 && !arrives; ++i)
    arrives = approach_in_drawn_order(linkage, straight.path, {}, Rng(1).stream(i)).path.waypoints.back().config ==
              goal(linkage);
  EXPECT_TRUE(arrives);
}

TEST(Orders, ADrawGivesTheSameWayAgain) {
  const Linkage linkage = open_sink();
  const FoldingPath begun = approach_goal(linkage, {}).path;
  const ContinuationResult one = approach_in_drawn_order(linkage, begun, {}, Rng(3));
  const ContinuationResult again = approach_in_drawn_order(linkage, begun, {}, Rng(3));
  ASSERT_EQ(one.path.waypoints.size(), again.path.waypoints.size());
  EXPECT_EQ(one.path.waypoints.back().config, again.path.waypoints.back().config);
  EXPECT_LT(closure(linkage.loops, one.path.waypoints.back().config).worst, 1e-9);
}

}  // namespace
}  // namespace plico
