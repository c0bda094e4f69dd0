// Planning by OMPL: the only source that knows it, so that a build without has one to leave out.
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/motion/collision.h"
#include "plico/motion/planner.h"

namespace plico {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr int kTriesPerSample = 100;  // for a discrete state that is new and free
constexpr unsigned kNeighbours = 10;  // of a state of the lazy roadmap

const double* angles(const ob::State* state) { return state->as<ob::RealVectorStateSpace::StateType>()->values; }

Configuration configuration(const ob::State* state, int hinges) {
  return Eigen::Map<const Configuration>(angles(state), hinges);
}

std::vector<int> hinge_depths(const Linkage& linkage) {
  std::vector<int> panel_depth(linkage.panels.size(), 0), depth(linkage.hinges.size(), 0);
  for (int p : linkage.order) {
    if (linkage.parent_panel[p] < 0) continue;
    panel_depth[p] = panel_depth[linkage.parent_panel[p]] + 1;
    depth[linkage.parent_hinge[p]] = panel_depth[p];
  }
  return depth;
}

// Counts the states that are looked at, and finds all of them in collision once there were enough or the run is over:
// planners ask in long loops between two looks at their terminator.
class BoundedChecker {
 public:
  BoundedChecker(const Linkage& linkage, double clearance, long most, const Run& run)
      : checker_(linkage, {.clearance = clearance}), most_(most), run_(run) {}

  bool collides(const Configuration& config) { return spent() || (++count_, checker_.collides(config)); }
  bool spent() const { return count_ >= most_ || run_.over(); }
  long count() const { return count_; }

 private:
  CollisionChecker checker_;
  long most_, count_ = 0;
  const Run& run_;
};

// Every fold angle is 0 or its target.
class DiscreteSampler : public ob::StateSampler {
 public:
  DiscreteSampler(const ob::StateSpace* space, const Linkage& linkage, BoundedChecker& checker, Rng rng)
      : ob::StateSampler(space),
        goal_(goal(linkage)),
        depth_(hinge_depths(linkage)),
        deepest_(depth_.empty() ? 1 : std::max(1, *std::max_element(depth_.begin(), depth_.end()))),
        checker_(checker),
        own_(rng) {}

  void sampleUniform(ob::State* state) override {
    Configuration config;
    bool fresh = false;
    for (int i = 0; i < kTriesPerSample && !fresh && !(i > 0 && checker_.spent()); ++i) {
      config = draw();
      fresh = !checker_.collides(config) && seen_.insert(key(config)).second;
    }
    // A roadmap full of equal states cannot grow; few hinges have few discrete states, so go in between.
    if (!fresh)
      for (int h = 0; h < config.size(); ++h) config[h] = goal_[h] * own_.uniform();
    std::copy(config.begin(), config.end(), state->as<ob::RealVectorStateSpace::StateType>()->values);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double) override {
    double* const values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    std::copy_n(angles(near), goal_.size(), values);
    const int h = own_.below(static_cast<int>(goal_.size()));
    values[h] = values[h] == 0 ? goal_[h] : 0;
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, deviation);
  }

 private:
  Configuration draw() {
    const int kind = own_.below(3);
    const double share = own_.uniform();
    Configuration config = goal_;
    for (int h = 0; h < config.size(); ++h) {
      const double place = depth_[h] / static_cast<double>(deepest_) + own_.uniform(-0.1, 0.1);
      const double rank = kind == 0 ? own_.uniform() : kind == 1 ? place : 1 - place;
      if (rank > share) config[h] = 0;
    }
    return config;
  }

  std::vector<bool> key(const Configuration& config) const {
    std::vector<bool> folded(config.size());
    for (int h = 0; h < config.size(); ++h) folded[h] = config[h] != 0;
    return folded;
  }

  Configuration goal_;
  std::vector<int> depth_;
  std::set<std::vector<bool>> seen_;
  int deepest_;
  BoundedChecker& checker_;
  Rng own_;
};

std::shared_ptr<ob::RealVectorStateSpace> make_space(const Linkage& linkage) {
  const int n = linkage.num_hinges();
  auto space = std::make_shared<ob::RealVectorStateSpace>(n);
  ob::RealVectorBounds bounds(n);
  const Configuration target = goal(linkage);
  for (int h = 0; h < n; ++h) {
    bounds.setLow(h, std::min(0.0, target[h]) - 1e-6);  // a flat crease still needs an interval
    bounds.setHigh(h, std::max(0.0, target[h]) + 1e-6);
  }
  space->setBounds(bounds);
  return space;
}

// OMPL's planners draw from generators whose seeds come from one sequence of the process, and so does their default
// index of neighbours, which decides among states at equal distances. With a seed and an index of their own, every
// answer is a function of its options.
std::uint_fast32_t own_seed(std::uint64_t seed) { return static_cast<std::uint_fast32_t>(seed % 0xffffffffU) + 1; }

template <class Base>
class PlainRoadmap : public Base {
 public:
  explicit PlainRoadmap(const ob::SpaceInformationPtr& space) : Base(space) {
    using State = typename Base::Vertex;
    this->template setNearestNeighbors<ompl::NearestNeighborsLinear>();
    this->nn_->setDistanceFunction([this](State a, State b) { return this->distanceFunction(a, b); });
  }
};

class SeededPrm : public PlainRoadmap<og::PRM> {
 public:
  SeededPrm(const ob::SpaceInformationPtr& space, std::uint64_t seed) : PlainRoadmap(space) {
    rng_.setLocalSeed(own_seed(seed));
  }
};

class SeededRrtConnect : public og::RRTConnect {
 public:
  SeededRrtConnect(const ob::SpaceInformationPtr& space, std::uint64_t seed) : og::RRTConnect(space) {
    rng_.setLocalSeed(own_seed(seed));
    setNearestNeighbors<ompl::NearestNeighborsLinear>();
  }
};

ob::PlannerPtr make_planner(Planner planner, const ob::SpaceInformationPtr& space, std::uint64_t seed) {
  switch (planner) {
    case Planner::LazyPrm: {
      auto lazy = std::make_shared<PlainRoadmap<og::LazyPRM>>(space);
      lazy->setMaxNearestNeighbors(kNeighbours);
      lazy->setRange(2 * space->getMaximumExtent());  // discrete states lie far apart
      return lazy;
    }
    case Planner::Prm:
      return std::make_shared<SeededPrm>(space, seed);
    case Planner::RrtConnect:
      return std::make_shared<SeededRrtConnect>(space, seed);
  }
  PLICO_ASSERT(false);
  return nullptr;
}

// From goal back to flat, as planned, to from flat to goal; times by the farthest any fold turns.
FoldingPath reversed(const og::PathGeometric& planned, const Linkage& linkage) {
  FoldingPath path;
  double length = 0;
  for (std::size_t i = planned.getStateCount(); i-- > 0;) {
    const Configuration config = configuration(planned.getState(static_cast<unsigned>(i)), linkage.num_hinges());
    if (!path.waypoints.empty()) {
      const double turn = (config - path.waypoints.back().config).lpNorm<Eigen::Infinity>();
      if (turn == 0) continue;
      length += turn;
    }
    path.waypoints.push_back({length, config});
  }
  for (Waypoint& w : path.waypoints) w.time /= length;
  path.waypoints.back().time = 1;
  return path;
}

}  // namespace

bool has_planners() { return true; }

void silence_planners() { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); }

PlannedPath plan_path(const Linkage& linkage, const PlannerOptions& options, const Run& run) {
  check(options);
  require_within_limits(linkage, goal(linkage), "the goal");
  BoundedChecker checker(linkage, options.clearance, options.max_states > 0 ? options.max_states : most_states(linkage),
                         run);
  PlannedPath result;
  if (goal(linkage).isZero()) return {Ending::Found, linear_path(linkage), 0};
  if (checker.collides(flat(linkage)) || checker.collides(goal(linkage))) return result;

  const auto space = make_space(linkage);
  const Rng rng = Rng(options.seed);
  std::uint64_t samplers = 0;
  space->setStateSamplerAllocator([&](const ob::StateSpace* of) {
    return std::make_shared<DiscreteSampler>(of, linkage, checker, rng.stream(samplers++));
  });
  space->setLongestValidSegmentFraction(options.resolution);
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(
      [&](const ob::State* state) { return !checker.collides(configuration(state, linkage.num_hinges())); });
  information->setup();

  ob::ScopedState<> folded(space), unfolded(space);
  const Configuration target = goal(linkage);
  for (int h = 0; h < linkage.num_hinges(); ++h) folded[h] = target[h], unfolded[h] = 0;
  const auto problem = std::make_shared<ob::ProblemDefinition>(information);
  problem->setStartAndGoalStates(folded, unfolded);
  const ob::PlannerPtr planner = make_planner(options.planner, information, options.seed);
  planner->setProblemDefinition(problem);
  planner->setup();
  const ob::PlannerStatus status = planner->solve(ob::PlannerTerminationCondition([&] { return checker.spent(); }));
  result.states_checked = checker.count();
  if (status != ob::PlannerStatus::EXACT_SOLUTION) {
    result.ending = run.over() ? run.ending() : Ending::Exhausted;
    return result;
  }
  result.ending = Ending::Found;
  result.path = reversed(*problem->getSolutionPath()->as<og::PathGeometric>(), linkage);
  return result;
}

}  // namespace plico
