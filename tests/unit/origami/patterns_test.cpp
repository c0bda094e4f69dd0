#include "plico/origami/patterns.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
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

TEST(Patterns, SizesOutOfRangeAreRefused) {
  EXPECT_THROW(miura({.columns = 0}), InvalidOption);
  EXPECT_THROW(miura({.sector = kPi / 2}), InvalidOption);
  EXPECT_THROW(waterbomb({.columns = 5}), InvalidOption);
}

}  // namespace
}  // namespace plico
