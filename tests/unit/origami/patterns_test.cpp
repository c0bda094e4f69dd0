#include "plico/origami/patterns.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/motion/collision.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

struct Counts {
  int real_vertices, creases, panels;
  bool operator==(const Counts&) const = default;
};

Counts counts(const CreasePattern& sheet) {
  return {static_cast<int>(real_vertices(sheet).size()), make_linkage(sheet).num_hinges(), sheet.num_faces()};
}

// GoogleTest looks for this name. NOLINTNEXTLINE(readability-identifier-naming)
void PrintTo(const Counts& c, std::ostream* out) {
  *out << c.real_vertices << " real vertices, " << c.creases << " creases, " << c.panels << " panels";
}

// Table 3.3 counts flat facet creases in its largest two patterns only; its 9 real vertices of the 5x5 are a misprint.
TEST(Patterns, CountsOfTable33ComeOut) {
  EXPECT_EQ(counts(miura({.columns = 3, .rows = 3})), (Counts{4, 12, 9}));
  EXPECT_EQ(counts(miura({.columns = 5, .rows = 5})), (Counts{16, 40, 25}));
  EXPECT_EQ(counts(miura({.columns = 24, .rows = 24, .facet_diagonals = true})), (Counts{529, 1680, 1152}));
  EXPECT_EQ(counts(waterbomb({.columns = 4, .rows = 6})), (Counts{15, 50, 36}));
  EXPECT_EQ(counts(waterbomb({.columns = 8, .rows = 10})), (Counts{63, 182, 120}));
  EXPECT_EQ(counts(waterbomb({.columns = 12, .rows = 22, .facet_horizontals = true})), (Counts{231, 758, 528}));
}

// The counts of the author's yoshimura_12_12.
TEST(Patterns, YoshimuraCountsItsTriangles) {
  EXPECT_EQ(counts(yoshimura({.columns = 12, .rows = 12})), (Counts{121, 408, 288}));
  for (const RealVertex& vertex : real_vertices(yoshimura())) EXPECT_EQ(vertex.hinges.size(), 6u);
}

TEST(Patterns, GoalsOfTessellationsClose) {
  const auto worst = [](const CreasePattern& sheet) {
    return closure(real_vertices(sheet), goal(make_linkage(sheet))).worst;
  };
  for (double angle : {0.0, 0.3, 1.0, 2.0, kPi}) {
    EXPECT_LT(worst(miura({.columns = 4, .rows = 5, .sector = 1, .zigzag_angle = angle})), 1e-12) << angle;
    EXPECT_LT(worst(waterbomb({.columns = 4, .rows = 6, .diagonal_angle = angle})), 1e-12) << angle;
    EXPECT_LT(worst(yoshimura({.columns = 4, .rows = 5, .sector = 0.7, .diagonal_angle = angle})), 1e-12) << angle;
  }
}

TEST(Patterns, YoshimuraBecomesATubeAtItsAngle) {
  for (const int columns : {5, 8, 12}) {
    const double tube = yoshimura_tube_angle(columns, radians(45));
    const auto sheet = [&](double beyond) {
      return yoshimura({.columns = columns, .rows = 4, .sector = radians(45), .diagonal_angle = tube + beyond});
    };
    const std::vector<Vec3> folded = folded_vertices(sheet(0));
    for (int y = 0; y <= 4; ++y)
      EXPECT_LT((folded[y * (columns + 1)] - folded[y * (columns + 1) + columns]).norm(), 1e-9) << columns << " " << y;
    const Linkage below = make_linkage(sheet(-0.01)), beyond = make_linkage(sheet(0.02));
    EXPECT_FALSE(CollisionChecker(below).collides(goal(below))) << columns;
    EXPECT_TRUE(CollisionChecker(beyond).collides(goal(beyond))) << columns;
  }
  EXPECT_EQ(yoshimura_tube_angle(1, radians(45)), kPi);
}

TEST(Patterns, SizesOutOfRangeAreRefused) {
  EXPECT_THROW(miura({.columns = 0}), InvalidOption);
  EXPECT_THROW(miura({.sector = kPi / 2}), InvalidOption);
  EXPECT_THROW(yoshimura({.rows = 0}), InvalidOption);
  EXPECT_THROW(waterbomb({.columns = 5}), InvalidOption);
}

}  // namespace
}  // namespace plico
