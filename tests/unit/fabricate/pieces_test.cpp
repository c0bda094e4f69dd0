#include "plico/fabricate/pieces.h"

#include <gmock/gmock.h>

#include "plico/base/rng.h"
#include "plico/fabricate/cells.h"
#include "plico/fabricate/split.h"
#include "plico/geom/convex2.h"
#include "plico/geom/rectangle_fit.h"

namespace plico {
namespace {

const std::vector<Vec2> kLetterU{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Contains, TouchingTheBoundaryIsInside) {
  EXPECT_TRUE(contains(kLetterU, std::vector<Vec2>{{0, 0}, {3, 0}, {3, 1}, {0, 1}}));
  EXPECT_FALSE(contains(kLetterU, std::vector<Vec2>{{0, 0}, {3, 0}, {3, 1.001}, {0, 1.001}}));
}

TEST(Contains, ABridgeOverABayIsNotInside) {
  EXPECT_FALSE(contains(kLetterU, std::vector<Vec2>{{0.5, 2}, {2.5, 2}, {2.5, 2.5}, {0.5, 2.5}}));
}

TEST(PieceGrid, GroupsDoNotSeeEachOther) {
  PieceGrid grid(2);
  grid.add({{0, 0}, {5, 0}, {5, 5}, {0, 5}}, 1);
  const std::vector<Vec2> inside{{4, 4}, {6, 4}, {6, 6}}, touching{{5, 0}, {6, 0}, {6, 5}};
  EXPECT_TRUE(grid.overlaps(inside, 1));
  EXPECT_FALSE(grid.overlaps(inside, 2));
  EXPECT_FALSE(grid.overlaps(touching, 1));
}

TEST(Cells, EveryCellWithAPointOfThePieceIsTaken) {
  Rng rng(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i < 5; ++i) points.emplace_back(rng.uniform(0, 90), rng.uniform(0, 40));
    const std::vector<Vec2> hull = convex_hull(points);
    Cells cells(90, 40);
    cells.cover(hull);
    for (int i = 0; i < 200; ++i) {
      Vec2 p = Vec2::Zero();
      double sum = 0;
      for (const Vec2& corner : hull) {
        const double w = rng.uniform();
        p += w * corner;
        sum += w;
      }
      p /= sum;
      EXPECT_TRUE(cells.at(static_cast<int>(p.x()), static_cast<int>(p.y())));
    }
  }
}

TEST(Cells, HitsAreThoseOfCellByCell) {
  Rng rng(4);
  for (int round = 0; round < 100; ++round) {
    Cells page(100, 20), shape(70, 6);
    for (int i = 0; i < 60; ++i) page.set(rng.below(100), rng.below(20));
    for (int i = 0; i < 12; ++i) shape.set(rng.below(70), rng.below(6));
    const int x = rng.below(140) - 70, y = rng.below(26) - 6;
    bool hit = false;
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 70; ++i)
        if (shape.at(i, j) && x + i >= 0 && x + i < 100 && y + j >= 0 && y + j < 20) hit |= page.at(x + i, y + j);
    EXPECT_EQ(page.hit_by(shape, x, y), hit);
  }
}

TEST(Split, ALongStripFitsTheDiagonalOnlyWhenTurned) {
  const std::vector<Vec2> strip{{0, 0}, {110, 0}, {110, 1}, {0, 1}};
  EXPECT_TRUE(angle_that_fits(strip, {80, 80}).has_value());
  EXPECT_FALSE(angle_that_fits(strip, {70, 70}).has_value());
  const double scale = largest_scale(strip, {70, 70});
  EXPECT_GT(scale, 0.85);
  EXPECT_LT(scale, 0.9);
}

}  // namespace
}  // namespace plico
