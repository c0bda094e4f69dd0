#include "plico/verify/flat_layers.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "plico/origami/bases.h"
#include "plico/origami/layer_order.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

using testing::HasSubstr;

// A strip of three rectangles of these lengths, both creases folded flat as valleys.
CreasePattern rolled(double first, double middle, double last) {
  CreasePattern strip;
  double x = 0;
  for (double length : {0.0, first, middle, last}) {
    x += length;
    strip.vertices.emplace_back(x, 0);
    strip.vertices.emplace_back(x, 1);
  }
  for (int i = 0; i < 3; ++i) {
    strip.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    strip.edges.push_back({2 * i, 2 * i + 2, Assignment::Boundary, 0});
    strip.edges.push_back({2 * i + 1, 2 * i + 3, Assignment::Boundary, 0});
  }
  for (int i = 0; i < 4; ++i) {
    const bool inside = i == 1 || i == 2;
    strip.edges.push_back({2 * i, 2 * i + 1, inside ? Assignment::Valley : Assignment::Boundary, inside ? kPi : 0});
  }
  return strip;
}

TEST(FlatLayers, OrdersThatWereFoundAreThoseThatPaperCanTake) {
  for (const auto& [name, sheet] : std::vector<std::pair<const char*, CreasePattern>>{
           {"miura", miura({.columns = 4, .rows = 3})},
           {"miura in facets", miura({.columns = 3, .rows = 2, .facet_diagonals = true})},
           {"diamond", diamond()},
           {"sailboat", sailboat()},
           {"square twist", square_twist()},
           {"roll", rolled(1, 3, 2)}}) {
    SCOPED_TRACE(name);
    const LayerOrder found = order_layers(sheet);
    ASSERT_EQ(found.ending, Ending::Found) << found.why;
    EXPECT_FALSE(found.orders.empty());
    const FlatLayersVerdict verdict = check_flat_layers(sheet, found.orders);
    EXPECT_TRUE(verdict.valid) << verdict.why;
    EXPECT_GT(verdict.places, 0);
  }
}

// Each flap covers the crease of the other, and whichever is inside, the crease around it runs through it.
TEST(FlatLayers, TwoFlapsThatReachBeyondEachOthersCreasesHaveNoOrder) {
  const LayerOrder found = order_layers(rolled(3, 1, 3));
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_THAT(found.why, HasSubstr("paper from passing through paper"));
}

TEST(FlatLayers, AFoldOnTheWrongSideIsSeen) {
  const CreasePattern sheet = miura({.columns = 3, .rows = 3});
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  const LayerOrder found = order_layers(sheet);
  int turned = 0;
  for (std::size_t i = 0; i < found.orders.size(); ++i) {
    const bool at_a_crease = std::any_of(sides.begin(), sides.end(), [&](const EdgeSides& s) {
      return std::minmax(s.left, s.right) == std::minmax(found.orders[i].f, found.orders[i].g);
    });
    if (!at_a_crease) continue;
    std::vector<FaceOrder> wrong = found.orders;
    wrong[i].side = -wrong[i].side;
    EXPECT_FALSE(check_flat_layers(sheet, wrong).valid);
    ++turned;
  }
  EXPECT_EQ(turned, 12);
}

TEST(FlatLayers, AFoldWithPaperInItIsSeen) {
  const CreasePattern strip = rolled(3, 1, 3);  // 0 and 2 both on the front of 1
  for (int inner : {0, 2}) {
    const int outer = 2 - inner;
    const FlatLayersVerdict verdict =
        check_flat_layers(strip, {{inner, 1, 1}, {outer, 1, 1}, {outer, inner, -1}});  // turned: its front looks down
    EXPECT_FALSE(verdict.valid);
    EXPECT_THAT(verdict.why, HasSubstr("has paper in it"));
  }
}

TEST(FlatLayers, EitherOfTwoFlapsThatOnlyOverlapMayLieOnTheOther) {
  const CreasePattern strip = rolled(2, 3, 2);
  for (int side : {1, -1}) EXPECT_TRUE(check_flat_layers(strip, {{0, 1, 1}, {2, 1, 1}, {0, 2, side}}).valid) << side;
}

TEST(FlatLayers, AMissingOrderIsSeen) {
  const FlatLayersVerdict verdict = check_flat_layers(rolled(2, 3, 2), {{0, 1, 1}, {2, 1, 1}});
  EXPECT_FALSE(verdict.valid);
  EXPECT_THAT(verdict.why, HasSubstr("have no order"));
}

TEST(FlatLayers, AreForGoalsThatAreFlat) {
  const CreasePattern sheet = miura({.columns = 3, .rows = 3, .zigzag_angle = radians(100)});
  EXPECT_THAT(order_layers(sheet).why, HasSubstr("the goal is not flat"));
  EXPECT_THAT(check_flat_layers(sheet, {}).why, HasSubstr("the goal is not flat"));
}

}  // namespace
}  // namespace plico
