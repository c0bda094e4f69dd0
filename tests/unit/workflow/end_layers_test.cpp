#include "plico/workflow/end_layers.h"

#include <gtest/gtest.h>

#include "plico/origami/bases.h"
#include "plico/origami/continuation.h"
#include "plico/origami/patterns.h"
#include "plico/verify/flat_layers.h"
#include "plico/workflow/plan_motion.h"

namespace plico {
namespace {

FoldingPath straight(const CreasePattern& sheet) {
  const Configuration folded = goal(make_linkage(sheet));
  return {{{0, 0 * folded}, {0.5, 0.5 * folded}, {1, folded}}};
}

// A strip folded in three.
CreasePattern strip(double first, double second) {
  CreasePattern sheet = l();
  for (Crease& crease : sheet.edges)
    if (crease.assignment == Assignment::Valley) crease.fold_angle = crease.a == 1 ? first : second;
  for (Crease& crease : sheet.edges)
    if (crease.fold_angle < 0) crease.assignment = Assignment::Mountain;
  return sheet;
}

// A motion without loops has two waypoints; its panels are apart between them only.
TEST(EndLayers, OfAStripFoldedToAndFroAreInTheOrderOfItsPanels) {
  const CreasePattern sheet = strip(kPi, -kPi);
  const Linkage linkage = make_linkage(sheet);
  const EndLayers layers = end_layers(sheet, linkage, linear_path(linkage));
  ASSERT_TRUE(layers.flat);
  EXPECT_EQ(layers.why, "");
  ASSERT_EQ(layers.orders.size(), 3U);
  EXPECT_TRUE(check_flat_layers(sheet, layers.orders).valid);
  // The first fold is a valley: panel 1 lies on the front of panel 0; the second a mountain: panel 2 on the back of 1,
  // which looks down, and so above both.
  const std::vector<FaceOrder> expected = {{0, 1, 1}, {0, 2, -1}, {1, 2, -1}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(layers.orders[i].f, expected[i].f);
    EXPECT_EQ(layers.orders[i].g, expected[i].g);
    EXPECT_EQ(layers.orders[i].side, expected[i].side) << i;
  }
}

// The judge refuses the same orders with one pair turned over.
TEST(EndLayers, AreTheOnlyOrderThatStandsTheCheck) {
  const CreasePattern sheet = miura({.columns = 3, .rows = 3});
  const MotionOutcome outcome = plan(make_linkage(sheet));
  ASSERT_TRUE(outcome.proven());
  EndLayers layers = end_layers(sheet, make_linkage(sheet), outcome.motions.front().path);
  ASSERT_GT(layers.orders.size(), 20U);
  for (FaceOrder& order : layers.orders) {
    order.side = -order.side;
    EXPECT_FALSE(check_flat_layers(sheet, layers.orders).valid) << order.f << " " << order.g;
    order.side = -order.side;
  }
}

// Of a fold that was closed before the last one began, the panels were apart long before the end.
TEST(EndLayers, SeePanelsThatCameTogetherEarly) {
  CreasePattern sheet = l2();
  for (Crease& crease : sheet.edges)
    if (crease.fold_angle != 0) crease.fold_angle = crease.fold_angle > 0 ? kPi : -kPi;
  const MotionOutcome outcome = plan(make_linkage(sheet));
  ASSERT_TRUE(outcome.proven());
  const EndLayers layers = end_layers(sheet, make_linkage(sheet), outcome.motions.front().path);
  EXPECT_EQ(layers.why, "");
  EXPECT_EQ(layers.orders.size(), 6U);  // four panels in one place
}

TEST(EndLayers, AreNotAskedForWhereTheEndIsNotFlat) {
  const CreasePattern sheet = strip(kPi, 1);
  const EndLayers layers = end_layers(sheet, make_linkage(sheet), straight(sheet));
  EXPECT_FALSE(layers.flat);
  EXPECT_TRUE(layers.orders.empty());
}

TEST(EndLayers, OfVeryManyPanelsAreNotLookedFor) {
  const CreasePattern sheet = miura({.columns = 25, .rows = 25});
  const EndLayers layers = end_layers(sheet, make_linkage(sheet), straight(sheet));
  ASSERT_TRUE(layers.flat);
  EXPECT_TRUE(layers.orders.empty());
  EXPECT_EQ(layers.why, "625 panels, at most 600 are put in order");
}

}  // namespace
}  // namespace plico
