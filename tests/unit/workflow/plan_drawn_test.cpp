#include "plico/workflow/plan_drawn.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/verify/deformation.h"

namespace plico {
namespace {

TEST(PlanDrawn, RefusesADeformationThatIsNotAShareOfPaper) {
  for (const double deformation : {-0.01, 1.001 * kMostDeformation})
    EXPECT_THROW(plan_drawn(square_twist(), {.facets = FacetPolicy::None, .deformation = deformation}), InvalidOption)
        << deformation;
}

// Whole panels of a square twist are locked: what moves is deformed, the more the farther, and never beyond its bound.
TEST(PlanDrawn, DeformsNoEdgeByMoreThanIsAllowed) {
  double before = 0;
  for (const double allowed : {0.01, 0.05}) {
    const MotionOutcome outcome = plan_drawn(square_twist(), {.facets = FacetPolicy::None, .deformation = allowed});
    ASSERT_TRUE(outcome.proven()) << allowed;
    EXPECT_GT(outcome.deformation, 0);
    EXPECT_LE(outcome.deformation, allowed);
    const FoldingPath& path = outcome.motions.front().path;
    EXPECT_EQ(measure_deformation(square_twist(), make_linkage(square_twist()), path).worst, outcome.deformation);
    EXPECT_GT(outcome.progress, before);
    before = outcome.progress;
  }
}

}  // namespace
}  // namespace plico
