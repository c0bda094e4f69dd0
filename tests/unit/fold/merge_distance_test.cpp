#include "plico/fold/merge_distance.h"

#include <gtest/gtest.h>

#include "plico/base/rng.h"
#include "plico/fold/arrange_lines.h"

namespace plico {
namespace {

// The cells of an n x n grid, each side a line of its own whose ends are off by up to `slip`.
std::vector<DrawnLine> sloppy_grid(int n, double slip, std::uint64_t seed) {
  Rng rng(seed);
  const auto near = [&](double x, double y) {
    const double dx = rng.uniform(-slip, slip), dy = rng.uniform(-slip, slip);
    return Vec2(x + dx, y + dy);
  };
  std::vector<DrawnLine> lines;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 a = near(i, j), b = near(i, j + 1), c = near(j, i), d = near(j + 1, i);
      lines.push_back({a, b, i % n == 0 ? Assignment::Boundary : Assignment::Mountain, 0, i});
      lines.push_back({c, d, i % n == 0 ? Assignment::Boundary : Assignment::Valley, 0, i});
    }
  return lines;
}

TEST(MergeDistance, IsTheCustomaryOneWhenNothingSpeaksAgainstIt) {
  EXPECT_EQ(merge_distances(sloppy_grid(10, 0, 1), 10, 1e-3)[0], 0.01);
  EXPECT_EQ(merge_distances(sloppy_grid(10, 1e-3, 1), 10, 1e-3)[0], 0.01);
}

TEST(MergeDistance, LiesAboveTheSlipsOfASloppyHand) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<DrawnLine> lines = sloppy_grid(8, 0.012, seed);  // ends up to 0.034 apart; customary are 0.008
    const Arrangement arranged = arrange_lines(lines, {.merge = 1e-3, .found = true});
    EXPECT_GT(arranged.distance, 0.02) << seed;
    EXPECT_EQ(arranged.sheet.num_faces(), 64) << seed;
  }
}

TEST(MergeDistance, LiesBelowTheCreasesOfALargePattern) {
  const int n = 60;
  std::vector<DrawnLine> lines = sloppy_grid(n, 1e-3, 1);
  lines.push_back({Vec2(0, 0), Vec2(60000, 0), Assignment::Boundary});  // so that creases are 1/60000 of the drawing
  const double distance = arrange_lines(lines, {.merge = 1e-3, .found = true}).distance;
  EXPECT_LT(distance, 0.5);
  EXPECT_GT(distance, 3e-3);
}

TEST(MergeDistance, CanBeAskedForInTheDrawingsUnit) {
  const std::vector<DrawnLine> lines = sloppy_grid(4, 0.05, 1);
  EXPECT_EQ(arrange_lines(lines, {.found = true, .distance = 0.2}).sheet.num_faces(), 16);
  EXPECT_EQ(arrange_lines(lines, {.found = true, .distance = 0.2}).distance, 0.2);
}

}  // namespace
}  // namespace plico
