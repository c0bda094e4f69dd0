// One contract for all planners, over every kind of linkage: what a planner takes it folds within all limits, proven;
// what it does not take it refuses with the code that its contract states.
#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

struct Case {
  std::string name;
  Linkage linkage;
  bool goal_is_beyond = false;
};

Linkage with_limits(Linkage linkage, double share_of_goal) {
  for (Hinge& hinge : linkage.hinges) {
    hinge.low = std::min(0.0, share_of_goal * hinge.target);
    hinge.high = std::max(0.0, share_of_goal * hinge.target);
  }
  return linkage;
}

// Axes on the side to which the panels fold, so that they lie on each other at the end.
Linkage thick_chain() { return thickened(make_linkage(square_strip({1.5, -1.5, 1})), 0.1, {0.05, -0.05, 0.05}); }

std::vector<Case> cases() {
  const Linkage chain = make_linkage(square_strip({1, -1, 1})), sheet = make_linkage(l2());
  return {{"chain", chain},
          {"thick chain", thick_chain()},
          {"thick chain with rolling hinges", thick_hinged(chain, 0.1, 0.06)},
          {"sheet with loops", sheet},
          {"thick sheet with loops", thickened(sheet, 0.01)},
          {"chain whose limits are its goal", with_limits(chain, 1)},
          {"chain whose goal is beyond its limits", with_limits(chain, 0.5), true},
          {"thick chain whose goal is beyond its limits", with_limits(thick_chain(), 0.5), true},
          {"sheet whose limits are its goal", with_limits(sheet, 1)},
          {"sheet whose goal is beyond its limits", with_limits(sheet, 0.5), true}};
}

// The code of the refusal that the contract states, empty when the planner takes the linkage.
std::string refusal(const PlannerContract& takes, const Case& sample) {
  const bool loops = sample.linkage.has_loops(), thick = sample.linkage.thickness > 0;
  if (loops && thick) return "fold/thick-loops";
  if (loops ? !takes.loops : !takes.trees) return "usage/option";
  if (!loops && sample.goal_is_beyond) return "fold/limits";
  EXPECT_TRUE(!thick || takes.thickness);
  return {};
}

void expect_honoured(const PlannerContract& takes, const Case& sample, const MotionOutcome& outcome) {
  EXPECT_EQ(outcome.ending, sample.goal_is_beyond ? Ending::Exhausted : Ending::Found);
  EXPECT_EQ(outcome.motions.empty(), sample.goal_is_beyond && !takes.goes_to_limits);
  for (const Motion& motion : outcome.motions) {
    EXPECT_EQ(waypoint_beyond_limits(sample.linkage, motion.path), -1);
    EXPECT_EQ(prove_path(sample.linkage, motion.path).verdict, PathVerdict::Free);
    const Configuration& end = motion.path.waypoints.back().config;
    const double rest = (end - goal(sample.linkage)).lpNorm<Eigen::Infinity>();
    EXPECT_EQ(rest < 1e-9, !sample.goal_is_beyond) << rest;
  }
  EXPECT_EQ(outcome.progress < 1, sample.goal_is_beyond) << outcome.progress;
}

TEST(PlannerContract, EveryPlannerHonoursOrRefusesEveryLinkage) {
  for (const std::string& planner : motion_methods()) {
    const MotionMethod method = motion_method(planner);
    const PlannerContract takes = contract(method);
    for (const Case& sample : cases()) {
      SCOPED_TRACE(planner + ": " + sample.name);
      const std::string code = refusal(takes, sample);
      try {
        const MotionOutcome outcome = plan(sample.linkage, {.method = method}, limited({}, 20));
        EXPECT_EQ(code, "");
        expect_honoured(takes, sample, outcome);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
      }
    }
  }
}

// A linkage knows its loops: what a sheet becomes is planned as the sheet is.
TEST(PlannerContract, ALinkageIsPlannedAsTheSheetItCameFrom) {
  for (const CreasePattern& sheet : {l2(), diamond(), letter(), waterbomb_base()}) {
    const FoldingPath of_linkage = plan(make_linkage(sheet)).motions.front().path;
    const FoldingPath of_sheet = plan_origami(sheet).motions.front().path;
    ASSERT_EQ(of_linkage.waypoints.size(), of_sheet.waypoints.size());
    for (std::size_t i = 0; i < of_sheet.waypoints.size(); ++i)
      EXPECT_EQ(of_linkage.waypoints[i].config, of_sheet.waypoints[i].config);
  }
}

TEST(PlannerContract, LoopsThatNobodyToldOfAreRefused) {
  Linkage sheet = make_linkage(l2());
  sheet.loops.clear();
  EXPECT_THROW(plan(sheet), InvalidInput);
}

}  // namespace
}  // namespace plico
