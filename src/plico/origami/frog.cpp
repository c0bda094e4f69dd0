#include "plico/origami/frog.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

void check(const FrogOptions& o) {
  require(o.step > 0, "step", o.step, "above 0");
  require(o.initial_weight >= 0 && o.initial_weight <= 1, "initial weight", o.initial_weight, "in [0, 1]");
  require(o.reward >= 0, "reward", o.reward, "at least 0");
  require(o.penalty >= 0, "penalty", o.penalty, "at least 0");
  require(o.max_samples >= 1, "max samples", o.max_samples, "at least 1");
  require(o.patience >= 1, "patience", o.patience, "at least 1");
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
  if (o.nlopt.low.size() + o.nlopt.high.size() > 0)
    throw InvalidOption("nlopt limits = a table must be empty: the limits are those of the sheet");
}

// Time by length, so that every part of the path goes at the same speed.
void spread_time(FoldingPath& path) {
  double length = 0;
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    if (i > 0) length += (path.waypoints[i].config - path.waypoints[i - 1].config).norm();
    path.waypoints[i].time = length;
  }
  for (Waypoint& waypoint : path.waypoints) waypoint.time = length > 0 ? waypoint.time / length : 0;
}

// A mountain stays a mountain; a crease that ends flat may go either way.
double lowest(double target) { return target > 0 ? 0 : -kPi; }

}  // namespace

class Frog::Search {
 public:
  Search(const Linkage& linkage, const FrogOptions& options)
      : options_(options),
        linkage_(linkage),
        projector_(linkage),
        checker_(linkage_, options.collision),
        target_(goal(linkage_)) {
    check(options);
    require_closable(linkage);
    projection_.tolerance = options.tolerance;
    projection_.low = options_.nlopt.low = target_.unaryExpr(&lowest).cwiseMax(lower_limits(linkage_));
    projection_.high = options_.nlopt.high = (-(-target_).unaryExpr(&lowest)).cwiseMin(upper_limits(linkage_));
  }

  FrogResult plan(const Configuration& start, const Configuration& goal, const Run& run) {
    FrogResult result;
    result.path.waypoints.push_back({0, start});
    result.distance = (goal - start).norm();
    if (!valid_end(start, result) || !valid_end(goal, result)) return result;
    Rng rng(options_.seed);
    long idle = 0;
    double mark = result.distance;
    double weight = options_.initial_weight;
    while (result.distance > 0) {
      if (run.over() || result.counts.sampled >= options_.max_samples || idle >= options_.patience) {
        if (run.over()) result.ending = run.ending();
        spread_time(result.path);
        return result;
      }
      const bool closer = result.distance <= options_.step ? reach(goal, result) : extend(goal, weight, rng, result);
      weight = std::clamp(closer ? weight + options_.reward : weight - options_.penalty, 0.0, 1.0);
      ++idle;
      if (result.distance <= mark - options_.step / 2) {
        idle = 0;
        mark = result.distance;
      }
      if (result.counts.sampled % 100 == 0) run.report("samples", result.counts.sampled, options_.max_samples);
    }
    spread_time(result.path);
    result.ending = Ending::Found;
    return result;
  }

  void set_patience(long samples) { options_.patience = samples; }

 private:
  bool valid_end(const Configuration& config, FrogResult& result) {
    ++result.counts.tested;
    const double open = closure(projector_.vertices(), config).worst;
    result.worst_residual = std::max(result.worst_residual, open);
    return open <= std::max(1e-9, options_.tolerance) && hinge_beyond_limits(linkage_, config) < 0 && !collides(config);
  }

  bool collides(const Configuration& config) { return options_.check_collisions && checker_.collides(config); }

  Projection find_foldable(const Configuration& near) {
    if (options_.find == FindFoldable::GaussNewton) return projector_.project(near, projection_);
    const Projection found = project_by_nlopt(projector_.vertices(), near, options_.nlopt);
    if (!found.closed) return found;
    Projection tight = projector_.project(found.config, projection_);
    tight.steps += found.steps;
    return tight;
  }

  // The last step goes to the goal itself, which was tested before.
  static bool reach(const Configuration& goal, FrogResult& result) {
    result.path.waypoints.push_back({0, goal});
    result.distance = 0;
    return true;
  }

  // Lines 4 to 13 of algorithm 1.
  bool extend(const Configuration& goal, double weight, Rng& rng, FrogResult& result) {
    const Configuration& closest = result.path.waypoints.back().config;
    Configuration random(closest.size());
    for (int h = 0; h < random.size(); ++h) random[h] = rng.uniform(projection_.low[h], projection_.high[h]);
    const Configuration direction = (1 - weight) * (random - closest) + weight * (goal - closest);
    ++result.counts.sampled;
    const Projection found = find_foldable(closest + options_.step * direction.normalized());
    result.counts.tested += found.steps + 1;
    if (!found.closed || (found.config - closest).norm() > 2 * options_.step || collides(found.config)) return false;
    ++result.counts.valid;
    const double distance = (goal - found.config).norm();
    if (distance >= result.distance) return false;
    result.distance = distance;
    result.worst_residual = std::max(result.worst_residual, found.closure.worst);
    result.path.waypoints.push_back({0, found.config});
    return true;
  }

  FrogOptions options_;
  ProjectOptions projection_;
  Linkage linkage_;
  Projector projector_;
  CollisionChecker checker_;
  Configuration target_;
};

Frog::Frog(const Linkage& linkage, const FrogOptions& options) : search_(std::make_unique<Search>(linkage, options)) {}
Frog::~Frog() = default;
Frog::Frog(Frog&&) noexcept = default;
Frog& Frog::operator=(Frog&&) noexcept = default;

FrogResult Frog::plan(const Configuration& start, const Configuration& goal, const Run& run) {
  return search_->plan(start, goal, run);
}

void Frog::set_patience(long samples) { search_->set_patience(samples); }

FrogResult frog(const Linkage& linkage, const FrogOptions& options, const Run& run) {
  return Frog(linkage, options).plan(flat(linkage), goal(linkage), run);
}

}  // namespace plico
