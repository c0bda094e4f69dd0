#include "plico/fabricate/joints.h"

#include <gtest/gtest.h>

#include "plico/geom/polygon.h"

namespace plico {
namespace {

// A facet of 30 x 20 mm on panel 0, its net as it is on the page.
const JointFacet kFacet{0, {{0, 0}, {30, 0}, {30, 20}, {0, 20}}, 0, "to B: 1"};

PageLayout one_part() {
  PageLayout layout;
  layout.parts.resize(1);
  return layout;
}

TEST(Joints, ARivetHasAHoleInTheMiddleAndTextBesideIt) {
  PageLayout layout = one_part();
  EXPECT_EQ(write_joints(layout, {kFacet}, JointKind::Rivet, {0}, {Placement{}}, Font()), 0);
  EXPECT_EQ(draw_joints(layout, {kFacet}, JointKind::Rivet, {0}, {Placement{}}), 0);
  const PlacedPart& part = layout.parts[0];
  ASSERT_EQ(part.labels.size(), 1u);
  const Vec2 middle(15, 10);
  EXPECT_GT((part.labels[0].center - middle).norm(), kRivet / 2 + part.labels[0].size / 2);
  ASSERT_EQ(part.marks.size(), 5u) << "outline, stroke, ring and cross";
  for (const Vec2& p : part.marks[2].points) EXPECT_NEAR((p - middle).norm(), kRivet / 2, 1e-9);
}

TEST(Joints, AHoleThatWouldTearIsLeftOutAndCounted) {
  PageLayout layout = one_part();
  JointFacet narrow = kFacet;
  narrow.polygon = {{0, 0}, {30, 0}, {30, 5}, {0, 5}};
  EXPECT_EQ(draw_joints(layout, {narrow}, JointKind::Rivet, {0}, {Placement{}}), 1);
  EXPECT_EQ(layout.parts[0].marks.size(), 2u);
}

TEST(Joints, OfNoKindLeaveTheFacetBlank) {
  PageLayout layout = one_part();
  write_joints(layout, {kFacet}, JointKind::None, {0}, {Placement{}}, Font());
  draw_joints(layout, {kFacet}, JointKind::None, {0}, {Placement{}});
  EXPECT_TRUE(layout.parts[0].marks.empty());
  EXPECT_TRUE(layout.parts[0].labels.empty());
}

}  // namespace
}  // namespace plico
