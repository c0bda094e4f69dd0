#include "plico/origami/nlopt_projection.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

// Half way to the goal, where the Miura is well away from its branch point, and then off by a few degrees.
Configuration disturbed(const std::vector<RealVertex>& vertices, const Configuration& target) {
  Configuration start = project(vertices, 0.5 * target).config;
  for (int h = 0; h < start.size(); ++h) start[h] += h % 2 == 0 ? 0.03 : -0.02;
  return start;
}

TEST(NloptProjection, ClosesLikeGaussNewtonButCostsMore) {
  const CreasePattern sheet = miura({.columns = 2, .rows = 2, .zigzag_angle = radians(120)});
  const auto vertices = real_vertices(sheet);
  const Configuration start = disturbed(vertices, goal(make_linkage(sheet)));
  ASSERT_GT(closure(vertices, start).worst, 1e-3);
  const Projection newton = project(vertices, start);
  for (const NloptAlgorithm algorithm : {NloptAlgorithm::Cobyla, NloptAlgorithm::Slsqp}) {
    const Projection found = project_by_nlopt(vertices, start, {.algorithm = algorithm});
    EXPECT_TRUE(found.closed);
    EXPECT_LE(found.closure.worst, 1e-4);
    EXPECT_LT((found.config - start).norm(), 5 * (newton.config - start).norm());
    EXPECT_GT(found.steps, newton.steps);
  }
}

TEST(NloptProjection, StaysWithinLimits) {
  const CreasePattern sheet = waterbomb_base();
  const auto vertices = real_vertices(sheet);
  Configuration start = 0.6 * goal(make_linkage(sheet));
  NloptOptions options;
  options.low = Configuration::Constant(start.size(), -0.5);
  options.high = Configuration::Constant(start.size(), 0.5);
  const Projection found = project_by_nlopt(vertices, start, options);
  EXPECT_LE(found.config.cwiseAbs().maxCoeff(), 0.5);
}

TEST(NloptProjection, SaysWhenItDoesNotClose) {
  const CreasePattern sheet = miura();
  const auto vertices = real_vertices(sheet);
  const Configuration start = disturbed(vertices, goal(make_linkage(sheet)));
  const Projection found = project_by_nlopt(vertices, start, {.max_evaluations = 3});
  EXPECT_FALSE(found.closed);
  EXPECT_GT(found.closure.worst, 1e-4);
  EXPECT_LE(found.steps, 5);
}

TEST(NloptProjection, OptionsAreChecked) {
  const auto vertices = real_vertices(l2());
  EXPECT_THROW(project_by_nlopt(vertices, Configuration::Zero(4), {.tolerance = 0}), InvalidOption);
  EXPECT_THROW(project_by_nlopt(vertices, Configuration::Zero(4), {.low = Configuration::Zero(3)}), InvalidInput);
  EXPECT_THROW(project_by_nlopt(vertices, Configuration::Zero(2)), InvalidInput);
}

}  // namespace
}  // namespace plico
