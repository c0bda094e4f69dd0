#include "plico/verify/overlap.h"

#include <gmock/gmock.h>

namespace plico {
namespace {

CreasePattern panels(const std::vector<std::vector<Vec2>>& polygons) {
  CreasePattern sheet;
  for (const std::vector<Vec2>& polygon : polygons) {
    std::vector<int>& face = sheet.faces.emplace_back();
    for (const Vec2& p : polygon) {
      face.push_back(sheet.num_vertices());
      sheet.vertices.push_back(p);
    }
  }
  return sheet;
}

std::vector<Vec2> square(double x, double y, double size = 1) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

TEST(Overlap, TouchingIsNoOverlap) {
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(1, 0)})).count, 0) << "along a side";
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(1, 1)})).count, 0) << "in a corner";
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(1, 0.3), square(-0.4, 1)})).count, 0) << "along parts of sides";
}

TEST(Overlap, TenMillionthOfAPanelIsFound) {
  const Overlaps overlaps = find_overlaps(panels({square(0, 0), square(1 - 1e-7, 0)}));
  ASSERT_EQ(overlaps.count, 1);
  EXPECT_NEAR(overlaps.worst.area, 1e-7, 3e-9);
}

TEST(Overlap, RoundingOfALayoutIsNoOverlap) {
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(1 - 1e-12, 0)})).count, 0);
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(1 - 1e-12, 0)}), {.shrink = 0}).count, 1)
      << "seen without shrinking";
}

TEST(Overlap, ContainedAndEqualPanelsAreFound) {
  EXPECT_EQ(find_overlaps(panels({square(0, 0, 3), square(1, 1)})).count, 1);
  EXPECT_EQ(find_overlaps(panels({square(0, 0), square(0, 0)})).count, 1);
  EXPECT_EQ(find_overlaps(panels({{{-2, 0}, {2, 0}, {0, 0.1}}, {{-0.1, -2}, {0.1, -2}, {0, 2}}})).count, 1)
      << "no corner inside";
}

TEST(Overlap, PanelsMayBeNonConvex) {
  const std::vector<Vec2> u{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_EQ(find_overlaps(panels({u, square(1, 1)})).count, 0) << "in the mouth of the U";
  EXPECT_EQ(find_overlaps(panels({u, square(1, 0.999)})).count, 1);
}

TEST(Overlap, TurnedOverPanelsCountAndEmptyOnesDoNot) {
  EXPECT_EQ(find_overlaps(panels({square(0, 0), {{0, 0}, {0, 1}, {1, 0}}})).count, 1);
  EXPECT_EQ(find_overlaps(panels({square(0, 0), {{-1, 0.5}, {0.5, 0.5}, {2, 0.5}}})).count, 0);
  EXPECT_EQ(find_overlaps({}).count, 0);
}

TEST(Overlap, ListIsSortedAndNamesTheWorst) {
  const Overlaps overlaps = find_overlaps(panels({square(5, 0), square(0.9, 0), square(4.5, 0), square(0, 0)}));
  ASSERT_EQ(overlaps.count, 2);
  EXPECT_EQ(overlaps.listed[0].a, 0);
  EXPECT_EQ(overlaps.listed[0].b, 2);
  EXPECT_EQ(overlaps.listed[1].a, 1);
  EXPECT_EQ(overlaps.listed[1].b, 3);
  EXPECT_EQ(overlaps.worst.a, 0);
  EXPECT_NEAR(overlaps.worst.area, 0.5, 1e-8);
  EXPECT_NEAR(overlaps.listed[1].area, 0.1, 1e-8);
}

TEST(Overlap, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(find_overlaps(panels({square(0, 0)}), {}, {.stop = source.get_token()}).complete);
  EXPECT_FALSE(find_overlaps(panels({square(0, 0), square(0, 0), square(0, 0)}), {.max_pairs = 1}).complete);
}

}  // namespace
}  // namespace plico
