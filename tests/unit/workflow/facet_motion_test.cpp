// Which sheets need panels that bend, and what is told of it.
#include <gmock/gmock.h>

#include <algorithm>

#include "plico/fold/planar_faces.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Concentric squares in turn mountain and valley, and their diagonals: curved when folded.
CreasePattern pleated_square(int rings) {
  CreasePattern sheet;
  sheet.vertices.emplace_back(0, 0);
  for (int r = 1; r <= rings; ++r)
    for (const Vec2& corner : {Vec2(r, r), Vec2(-r, r), Vec2(-r, -r), Vec2(r, -r)}) sheet.vertices.push_back(corner);
  const auto vertex = [](int r, int i) { return r == 0 ? 0 : 4 * (r - 1) + i % 4 + 1; };
  for (int r = 1; r <= rings; ++r)
    for (int i = 0; i < 4; ++i) {
      const bool border = r == rings;
      const double ring = r % 2 == 1 ? kPi : -kPi, diagonal = i % 2 ? kPi : -kPi;
      sheet.edges.push_back(
          {vertex(r, i), vertex(r, i + 1), border ? Assignment::Boundary : assignment_of(ring), border ? 0 : ring});
      sheet.edges.push_back({vertex(r - 1, i), vertex(r, i), assignment_of(diagonal), diagonal});
    }
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

void expect_bends_are_told(const CreasePattern& sheet, double least_share) {
  const MotionOutcome whole = plan_origami(sheet, {.facets = FacetPolicy::None});
  const MotionOutcome cut = plan_origami(sheet);
  ASSERT_TRUE(cut.proven());
  EXPECT_GT(cut.progress, least_share);
  EXPECT_GT(cut.progress, whole.proven() ? whole.progress : 0);
  ASSERT_EQ(cut.bends.size(), sheet.faces.size());  // one a panel
  EXPECT_GT(*std::max_element(cut.bends.begin(), cut.bends.end()), radians(1));
  EXPECT_THAT(cut.notes, Contains(HasSubstr("cut by flat creases")));
}

TEST(FacetMotion, ASquareTwistFoldsWithPanelsThatBend) { expect_bends_are_told(square_twist(), 0.7); }

TEST(FacetMotion, AHyparFoldsWithPanelsThatBend) { expect_bends_are_told(pleated_square(3), 0.15); }

TEST(FacetMotion, AMiuraNeedsNone) {
  const MotionOutcome outcome = plan_origami(miura({.columns = 4, .rows = 4}));
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.ending, Ending::Found);
  EXPECT_TRUE(outcome.bends.empty());
  EXPECT_FALSE(outcome.sheet.has_value());
}

TEST(FacetMotion, FacetsOfAMiuraStayFlatWhenAllAreCut) {
  const MotionOutcome whole = plan_origami(miura({.columns = 3, .rows = 3}), {.facets = FacetPolicy::All});
  ASSERT_TRUE(whole.proven());
  EXPECT_GT(whole.progress, 0.98);
}

}  // namespace
}  // namespace plico
