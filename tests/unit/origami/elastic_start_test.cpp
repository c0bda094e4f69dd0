#include "plico/origami/elastic_start.h"

#include <gtest/gtest.h>

#include "pattern_samples.h"
#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/facets.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

TEST(ElasticStart, ComesAboutAsFarAsItIsPulled) {
  const CreasePattern sheet = cut_into_facets(pleated_square(3)).sheet;
  const ContinuationResult begun = start_elastically(sheet, {.share = 0.3});
  ASSERT_GT(begun.path.waypoints.size(), 2U);
  EXPECT_GT(begun.progress, 0.05);
  EXPECT_LT(begun.progress, 0.4);
}

TEST(ElasticStart, BeginsFlatAndStaysClosedAndInOneMotion) {
  const CreasePattern sheet = cut_into_facets(pleated_square(3)).sheet;
  const std::vector<RealVertex> loops = real_vertices(sheet);
  const ContinuationResult begun = start_elastically(sheet, {});
  const std::vector<Waypoint>& waypoints = begun.path.waypoints;
  ASSERT_GT(waypoints.size(), 2U);
  EXPECT_EQ(waypoints.front().config.cwiseAbs().maxCoeff(), 0);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    EXPECT_LT(closure(loops, waypoints[i].config).worst, 1e-9);
    EXPECT_GT(waypoints[i].time, waypoints[i - 1].time);
    EXPECT_LT((waypoints[i].config - waypoints[i - 1].config).cwiseAbs().maxCoeff(), radians(8));
  }
}

TEST(ElasticStart, OfALockedSheetIsFlat) {
  const ContinuationResult begun = start_elastically(square_twist(), {});
  EXPECT_EQ(begun.path.waypoints.size(), 1U);
  EXPECT_EQ(begun.progress, 0);
}

TEST(ElasticStart, RefusesOptionsOutOfRange) {
  EXPECT_THROW(start_elastically(miura(), {.share = 0}), InvalidOption);
  EXPECT_THROW(start_elastically(miura(), {.softest = 1}), InvalidOption);
}

}  // namespace
}  // namespace plico
