#include "plico/workflow/hand_work.h"

#include <gtest/gtest.h>

#include "plico/shapes/named_shapes.h"
#include "plico/workflow/unfold_mesh.h"

namespace plico {
namespace {

TEST(HandWork, IsTooSmallWhenATenthOfIdsOrAThirdOfTabsIsMissing) {
  HandWork work{.edges = 100, .small = 50, .ids = 100, .omitted = 10, .seams = 30, .bare = 10};
  EXPECT_FALSE(work.too_small());
  work.omitted = 11;
  EXPECT_TRUE(work.too_small());
  work.omitted = 0;
  work.bare = 11;
  EXPECT_TRUE(work.too_small());
  work.bare = 0;
  work.small = 51;
  EXPECT_TRUE(work.too_small());
}

struct Printed {
  FoldedShape shape;
  Unfolding net;
  LayoutOptions options;
  LayoutReport report;

  Printed(const Mesh& mesh, double longest) : shape(folded_shape(mesh)), net(unfold_mesh(mesh).unfolding) {
    options.size.longest = longest;
    report = lay_out_pages(net, shape, options).report;
  }
};

TEST(HandWork, CountsSeamsWithoutTabsWhetherShortOrCrowded) {
  const Printed fish(Mesh(make_shape("fish", {.faces = 100})), 25);
  const HandWork work = hand_work(fish.net, fish.report);
  EXPECT_GT(fish.report.tabs.short_seams, 0);
  EXPECT_EQ(work.seams - work.bare, static_cast<int>(fish.report.tabs.tabs.size()));
  EXPECT_EQ(work.edges, 150);
}

TEST(LargerPages, AreLaidOutAndNoLongerTooSmall) {
  const Printed fish(Mesh(make_shape("fish", {.faces = 100})), 40);
  ASSERT_TRUE(hand_work(fish.net, fish.report).too_small());
  const auto larger = larger_pages(fish.net, fish.shape, fish.options, fish.report, {});
  ASSERT_TRUE(larger.has_value());
  EXPECT_GT(larger->longest_mm, 40);
  EXPECT_LE(larger->longest_mm, 165);
  const Printed again(Mesh(make_shape("fish", {.faces = 100})), larger->longest_mm);
  const HandWork work = hand_work(again.net, again.report);
  EXPECT_FALSE(work.too_small());
  EXPECT_EQ(work.omitted, larger->work.omitted);
  EXPECT_EQ(work.bare, larger->work.bare);
}

TEST(LargerPages, AreNoneOfAShapeThatIsFarTooSmall) {
  const Printed fish(Mesh(make_shape("fish", {.faces = 100})), 2);
  EXPECT_FALSE(larger_pages(fish.net, fish.shape, fish.options, fish.report, {}).has_value());
}

}  // namespace
}  // namespace plico
