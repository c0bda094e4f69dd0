#include "plico/origami/elastic_start.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr int kStepsEach = 2;          // of Gauss-Newton at each stiffness
constexpr double kLeastFolded = 0.01;  // radians: less is flat
constexpr double kClosedWell = 1e-9;   // radians

// Pulled to `target`, ever softer.
Projection relax(Projector& projector, const Configuration& target, ProjectOptions options, double softest,
                 const Run& run) {
  const double end = options.damping;
  Configuration at = target;
  options.max_steps = 1;
  for (double stiffness = 1; stiffness > softest && !run.over(); stiffness /= 2) {
    options.damping = stiffness;
    for (int i = 0; i < kStepsEach; ++i) {
      at = projector.project(at, options, run).config;
      at += projector.tangent(at, target - at, options);
    }
  }
  options.damping = end;
  options.max_steps = 100;
  return projector.project(at, options, run);
}

ProjectOptions on_their_sides(const Linkage& linkage, ProjectOptions options) {
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    if (linkage.hinges[h].target > 0) options.low[h] = std::max(0.0, options.low[h]);
    if (linkage.hinges[h].target < 0) options.high[h] = std::min(0.0, options.high[h]);
  }
  return options;
}

Linkage with_flat_goal(Linkage linkage) {
  for (Hinge& hinge : linkage.hinges) hinge.target = 0;
  return linkage;
}

ProjectOptions projection_of(const Linkage& linkage, const ApproachOptions& options) {
  ProjectOptions projection;
  projection.low = lower_limits(linkage);
  projection.high = upper_limits(linkage);
  projection.weight = Configuration::Ones(linkage.num_hinges());
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (linkage.hinges[h].target == 0) projection.weight[h] = options.facet_weight;
  return projection;
}

// The motion from flat to a state that creases were pulled to; flat alone when there is none.
ContinuationResult start_within(const Linkage& linkage, const ElasticOptions& elastic, const ProjectOptions& projection,
                                const ApproachOptions& options, const Run& run) {
  ContinuationResult result;
  result.path.waypoints = {{0, flat(linkage)}};
  Projector projector(linkage);
  const Projection state = relax(projector, elastic.share * goal(linkage), projection, elastic.softest, run);
  if (run.over() || state.closure.worst > kClosedWell || state.config.cwiseAbs().maxCoeff() < kLeastFolded)
    return result;
  if (options.check_collisions && CollisionChecker(linkage, options.collision).collides(state.config)) return result;
  ApproachOptions back = options;
  back.keep_sides = false;
  FoldingPath folded;
  folded.waypoints = {{0, state.config}, {1, state.config}};
  ContinuationResult unfolded = approach_goal(with_flat_goal(linkage), folded, back, run);
  result.steps = unfolded.steps;
  if (unfolded.ending != Ending::Found) return result;
  std::vector<Waypoint>& waypoints = unfolded.path.waypoints;
  waypoints.erase(waypoints.begin());  // the state is there twice
  std::reverse(waypoints.begin(), waypoints.end());
  for (Waypoint& w : waypoints) w.time = 1 - w.time;
  result.path = std::move(unfolded.path);
  result.progress = share_of_way(linkage, result.path.waypoints.back().config);
  return result;
}

}  // namespace

ContinuationResult start_elastically(const Linkage& linkage, const ElasticOptions& elastic,
                                     const ApproachOptions& options, const Run& run) {
  require(elastic.share > 0 && elastic.share <= 1, "share", elastic.share, "in (0, 1]");
  require(elastic.softest > 0 && elastic.softest < 1, "softest", elastic.softest, "in (0, 1)");
  require_closable(linkage);
  const ProjectOptions projection = projection_of(linkage, options);
  if (options.keep_sides) {
    ContinuationResult sided = start_within(linkage, elastic, on_their_sides(linkage, projection), options, run);
    if (sided.path.waypoints.size() > 1 || !elastic.may_turn_back) return sided;
  }
  return start_within(linkage, elastic, projection, options, run);
}

}  // namespace plico
