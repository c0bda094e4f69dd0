#include "plico/verify/deformation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/origami/bases.h"
#include "plico/origami/continuation.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

// Of the four panels of a cross the last in the tree, turned about its own hinge, so that the hinge that closes the
// loop comes apart.
Configuration opened(const Linkage& linkage, double angle) {
  Configuration config = flat(linkage);
  config[linkage.parent_hinge[linkage.order.back()]] = angle;
  return config;
}

TEST(Deformation, IsThatOfAVertexAtTheMeanOfItsPlaces) {
  const CreasePattern cross = l2();
  const Linkage linkage = make_linkage(cross);
  const FoldingPath path{{{0, flat(linkage)}, {0.5, opened(linkage, kPi / 3)}, {1, opened(linkage, kPi / 6)}}};
  const Deformation measured = measure_deformation(cross, linkage, path);
  // The end of the spoke that opens has two places, 60 degrees apart on a circle about the centre.
  EXPECT_NEAR(measured.worst, 1 - std::cos(kPi / 6), 1e-12);
  EXPECT_EQ(measured.waypoint, 1);
  const int spoke = linkage.hinges[linkage.loop_hinges.front()].edge;
  EXPECT_EQ(measured.edge, spoke);
}

TEST(Deformation, IsAShareThatNoScaleChanges) {
  CreasePattern cross = l2();
  const FoldingPath path{{{0, flat(make_linkage(cross))}, {1, opened(make_linkage(cross), 0.2)}}};
  const double small = measure_deformation(cross, make_linkage(cross), path).worst;
  for (Vec2& p : cross.vertices) p *= 1000;
  EXPECT_NEAR(measure_deformation(cross, make_linkage(cross), path).worst, small, 1e-12);
}

TEST(Deformation, OfAMotionThatClosesIsNothing) {
  const CreasePattern sheet = miura({.columns = 4, .rows = 4});
  const ContinuationResult found = continue_to_goal(sheet);
  ASSERT_EQ(found.ending, Ending::Found);
  EXPECT_LT(measure_deformation(sheet, make_linkage(sheet), found.path).worst, 1e-11);
}

TEST(Deformation, OfAPathThatStaysFlatHasNoPlace) {
  const CreasePattern cross = l2();
  const Linkage linkage = make_linkage(cross);
  const Deformation measured = measure_deformation(cross, linkage, {{{0, flat(linkage)}, {1, flat(linkage)}}});
  EXPECT_EQ(measured.worst, 0);
  EXPECT_EQ(measured.waypoint, -1);
  EXPECT_EQ(measured.edge, -1);
}

// A thousandth of the mean side is the clearance of motions that close; so much more for every thousandth of
// deformation.
TEST(Deformation, WidensTheClearanceByItsShareOfTheMeanSide) {
  const Linkage linkage = make_linkage(miura());
  const double side = mean_side_length(linkage), clearance = 1e-3 * side;
  EXPECT_EQ(deformed_clearance(clearance, 0), clearance);
  EXPECT_NEAR(deformed_clearance(clearance, 0.05), clearance + 0.05 * side, 1e-12);
}

}  // namespace
}  // namespace plico
