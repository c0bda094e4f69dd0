#include "plico/fold/arrange_lines.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/fold/linkage.h"

namespace plico {
namespace {

using testing::IsEmpty;

std::vector<DrawnLine> frame(double size) {
  const Vec2 a(0, 0), b(size, 0), c(size, size), d(0, size);
  return {{a, b, Assignment::Boundary},
          {b, c, Assignment::Boundary},
          {c, d, Assignment::Boundary},
          {d, a, Assignment::Boundary}};
}

// n - 1 full-width lines each way, every second one in two overlapping pieces.
std::vector<DrawnLine> grid(int n) {
  std::vector<DrawnLine> lines = frame(n);
  for (int i = 1; i < n; ++i) {
    lines.push_back({Vec2(i, 0), Vec2(i, n), Assignment::Mountain, -kPi, i});
    if (i % 2 == 0) lines.push_back({Vec2(0.0, i), Vec2(n, i), Assignment::Valley, kPi, i});
    if (i % 2 == 0) continue;
    lines.push_back({Vec2(0.0, i), Vec2(0.65 * n, i), Assignment::Valley, kPi, i});
    lines.push_back({Vec2(0.35 * n, i), Vec2(n, i), Assignment::Valley, kPi, i});
  }
  return lines;
}

TEST(ArrangeLines, ACleanDrawingIsLeftAlone) {
  std::vector<DrawnLine> lines = frame(1);
  lines.push_back({Vec2(0, 0), Vec2(1, 1), Assignment::Valley, 1});
  const Arrangement arranged = arrange_lines(lines);
  EXPECT_EQ(arranged.sheet.num_edges(), 5);
  EXPECT_EQ(arranged.sheet.num_faces(), 2);
  EXPECT_THAT(notes(arranged), IsEmpty());
}

TEST(ArrangeLines, AGridOfLongLinesBecomesItsCells) {
  const int n = 10;
  const Arrangement arranged = arrange_lines(grid(n));
  EXPECT_EQ(arranged.sheet.num_faces(), n * n);
  EXPECT_EQ(arranged.crossings, (n - 1) * (n - 1));
  EXPECT_EQ(arranged.conflicts, 0);
  EXPECT_GT(arranged.duplicates, 0);
}

TEST(ArrangeLines, NearEndsAreJoinedAndGapsAreNot) {
  std::vector<DrawnLine> lines = frame(100);
  lines.push_back({Vec2(0.005, 0.003), Vec2(99.996, 100.004), Assignment::Mountain, -1});
  const Arrangement joined = arrange_lines(lines, {.merge = 1e-3});
  EXPECT_EQ(joined.joined_ends, 2);
  EXPECT_EQ(joined.sheet.num_faces(), 2);
  lines.back() = {Vec2(10, 10), Vec2(90, 90), Assignment::Mountain, -1};
  const Arrangement apart = arrange_lines(lines, {.merge = 1e-3});
  EXPECT_EQ(apart.loose, 1);
  EXPECT_EQ(apart.sheet.num_faces(), 1);
}

TEST(ArrangeLines, LinesFromRimToRimCutTheWholeSheet) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng(seed);
    std::vector<DrawnLine> lines = frame(1);
    for (int i = 0; i < 20; ++i) {
      lines.push_back({Vec2(0, rng.uniform()), Vec2(1, rng.uniform()), Assignment::Mountain, -1, i});
      lines.push_back({Vec2(rng.uniform(), 0), Vec2(rng.uniform(), 1), Assignment::Valley, 1, i});
    }
    const Arrangement arranged = arrange_lines(lines, {.merge = seed % 2 ? 1e-6 : 1e-4});
    double area = 0;
    for (int f = 0; f < arranged.sheet.num_faces(); ++f) {
      const std::vector<Vec2> p = polygon(arranged.sheet, f);
      for (std::size_t i = 0; i < p.size(); ++i) area += cross(p[i], p[(i + 1) % p.size()]) / 2;
    }
    EXPECT_NEAR(area, 1, 1e-9) << seed;
  }
}

TEST(ArrangeLines, NothingTurnsAboutACut) {
  std::vector<DrawnLine> lines = frame(1);
  lines.push_back({Vec2(0.5, 0), Vec2(0.5, 1), Assignment::Cut, 0});
  EXPECT_EQ(make_linkage(arrange_lines(lines).sheet).num_hinges(), 0);
}

TEST(ArrangeLines, OptionsAreChecked) {
  EXPECT_THROW(arrange_lines(frame(1), {.merge = 0}), InvalidOption);
  EXPECT_THROW(arrange_lines({}), InvalidInput);
}

}  // namespace
}  // namespace plico
