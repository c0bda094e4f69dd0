#include "plico/origami/continuation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr double kSignTolerance = 1e-7;  // radians: noise of a crease that is flat at the moment
constexpr double kOvershoot = 10;        // times what a goal may turn: a search that strays farther will not come back
constexpr double kGoalTolerance = 1e-9;  // radians: residual of a goal that closes

void check(const ContinuationOptions& o) {
  require(o.frames >= 1, "frames", o.frames, "at least 1");
  require(o.first_step > 0 && o.first_step <= 1, "first step", o.first_step, "in (0, 1]");
  require(o.min_progress > 0, "min progress", o.min_progress, "above 0");
  require(o.max_move > 0, "max move", o.max_move, "above 0");
  require(o.goal_slack >= 0, "goal slack", o.goal_slack, "at least 0");
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
}

// Near flat a crease of a flat-foldable vertex turns in proportion to the tangent of half its goal.
Configuration half_tangents(const Configuration& goal) {
  const Configuration result = (goal.array().min(0.99 * kPi).max(-0.99 * kPi) / 2).tan().matrix();
  return result.norm() > 0 ? Configuration(goal.norm() / result.norm() * result) : result;
}

// What became of one frame.
struct Frame {
  Obstacle obstacle = Obstacle::None;
  Projection projection;
  Configuration guess;
  int hinge = -1;  // or group
  PanelPair panels;
};

// Creases that turn together. What the continuation moves are their angles, of the sign that the first crease has.
class Groups {
 public:
  Groups(const Linkage& linkage, const std::vector<int>& given) : group_(given), sign_(linkage.hinges.size(), 1) {
    if (group_.empty()) {
      group_.resize(linkage.hinges.size());
      std::iota(group_.begin(), group_.end(), 0);
    }
    if (group_.size() != linkage.hinges.size())
      throw InvalidOption(fmt::format("groups = {} must be one for each of {} creases", group_.size(), sign_.size()));
    for (int h = 0; h < linkage.num_hinges(); ++h) {
      const int g = group_[h];
      if (g < 0 || g >= linkage.num_hinges())
        throw InvalidOption(fmt::format("groups = {} must be in [0, {})", g, linkage.num_hinges()));
      if (g >= size()) first_.resize(g + 1, -1);
      if (first_[g] < 0) first_[g] = h;
      const double target = linkage.hinges[h].target, leader = linkage.hinges[first_[g]].target;
      if (std::abs(std::abs(target) - std::abs(leader)) > 1e-9)
        throw InvalidOption(fmt::format(
            "groups = {} must not hold creases {} and {}: their goals are of different size", g, first_[g], h));
      sign_[h] = target * leader < 0 ? -1 : 1;
    }
    if (std::find(first_.begin(), first_.end(), -1) != first_.end())
      throw InvalidOption("groups = a gap must be closed: a number between two groups has no crease");
  }

  int size() const { return static_cast<int>(first_.size()); }
  int first(int group) const { return first_[group]; }
  std::vector<RealVertex> loops(const std::vector<RealVertex>& all, const std::vector<int>& essential) const {
    if (essential.empty()) return grouped(all, group_, sign_);
    std::vector<RealVertex> some;
    for (int v : essential) {
      if (v < 0 || v >= static_cast<int>(all.size()))
        throw InvalidOption(fmt::format("essential = {} must be in [0, {})", v, all.size()));
      some.push_back(all[v]);
    }
    return grouped(std::move(some), group_, sign_);
  }
  Configuration goals(const Linkage& linkage) const {
    Configuration goals(size());
    for (int g = 0; g < size(); ++g) goals[g] = linkage.hinges[first_[g]].target;
    return goals;
  }
  Configuration expand(const Configuration& angles) const {
    Configuration config(static_cast<int>(group_.size()));
    for (int h = 0; h < config.size(); ++h) config[h] = sign_[h] * angles[group_[h]];
    return config;
  }
  // Narrows the limits of the group to those of the crease.
  void limit(int h, double low, double high, ProjectOptions& options) const {
    double &group_low = options.low[group_[h]], &group_high = options.high[group_[h]];
    group_low = std::max(group_low, sign_[h] > 0 ? low : -high);
    group_high = std::min(group_high, sign_[h] > 0 ? high : -low);
  }

 private:
  std::vector<int> group_, sign_;  // of each hinge
  std::vector<int> first_;         // hinge of each group
};

class Continuation {
 public:
  Continuation(const Linkage& linkage, const ContinuationOptions& options, const Run& run)
      : options_(options),
        run_(run),
        groups_(linkage, options.groups),
        projector_(groups_.loops(linkage.loops, options.essential), groups_.size()),
        goal_(groups_.goals(linkage)),
        checker_(linkage, options.collision),
        vertices_of_(groups_.size()) {
    for (const RealVertex& vertex : projector_.vertices())
      for (int g : vertex.hinges) vertices_of_[g].push_back(vertex.vertex);
    set_limits(linkage);
  }

  ContinuationResult plan() {
    ContinuationResult result;
    const Configuration start = Configuration::Zero(groups_.size());
    result.path.waypoints.push_back({0, groups_.expand(start)});
    if (!close_goal(result)) return result;
    walk(result, start, goal_);
    if (result.obstacle == Obstacle::None || !options_.unfold_too) return result;
    if (options_.check_collisions && checker_.collides(groups_.expand(goal_))) return result;
    ContinuationResult back;
    back.path.waypoints.push_back({0, groups_.expand(goal_)});
    walk(back, goal_, start);
    back.steps += result.steps;
    if (back.ending != Ending::Found) return result;
    std::reverse(back.path.waypoints.begin(), back.path.waypoints.end());
    for (Waypoint& waypoint : back.path.waypoints) waypoint.time = 1 - waypoint.time;
    back.unfolded = true;
    return back;
  }

 private:
  void set_limits(const Linkage& linkage) {
    projection_.tolerance = options_.tolerance;
    projection_.low = Configuration::Constant(groups_.size(), -kPi);
    projection_.high = -projection_.low;
    for (int h = 0; h < linkage.num_hinges(); ++h)
      groups_.limit(h, linkage.hinges[h].low, linkage.hinges[h].high, projection_);
  }

  // Clamps the goal and makes it close; false when no form near it does.
  bool close_goal(ContinuationResult& result) {
    const Configuration clamped = goal_.cwiseMax(projection_.low).cwiseMin(projection_.high);
    const bool is_clamped = !clamped.isApprox(goal_, 1e-14);
    goal_ = clamped;
    const Closure at_goal = closure(projector_.vertices(), goal_);
    if (at_goal.worst <= kGoalTolerance) return true;
    ProjectOptions projection = projection_;
    if (!is_clamped) projection.most_turn = kOvershoot * (options_.goal_slack + kGoalTolerance);
    const Projection near = projector_.project(goal_, projection, run_);
    result.steps += near.steps;
    const double move = (near.config - goal_).cwiseAbs().maxCoeff();
    if (near.closure.worst <= kGoalTolerance && (is_clamped || move <= options_.goal_slack)) {
      goal_ = near.config;
      return true;
    }
    result.obstacle = Obstacle::GoalOpen;
    result.vertex = at_goal.worst_vertex;
    result.residual = at_goal.worst;
    return false;
  }

  void walk(ContinuationResult& result, const Configuration& start, const Configuration& target) {
    const double full = 1.0 / options_.frames;
    double step = full;
    Configuration config = start;
    Configuration correction = Configuration::Zero(config.size());  // per unit of progress: what the last step was off
    const auto accept = [&](const Frame& frame, double next) {
      PLICO_ASSERT(next > result.progress && next <= 1);
      correction = (frame.projection.config - frame.guess) / (next - result.progress);
      config = frame.projection.config;
      result.worst_residual = std::max(result.worst_residual, frame.projection.closure.worst);
      result.progress = next;
      result.path.waypoints.push_back({next, groups_.expand(config)});
    };
    if (start.squaredNorm() == 0)
      if (const std::optional<Frame> first = leave_flat(result)) accept(*first, first_step_);
    while (result.progress < 1) {
      if (run_.over()) {
        result.ending = run_.ending();
        return;
      }
      const double next = result.progress + step > 1 - 1e-12 ? 1 : result.progress + step;
      const Configuration straight = config + (next - result.progress) / (1 - result.progress) * (target - config);
      Frame frame = try_frame(result, config, straight,
                              next == 1 ? Configuration(target) : straight + (next - result.progress) * correction);
      if (frame.obstacle != Obstacle::None) {
        step /= 2;
        correction.setZero();
        if (step >= options_.min_progress) continue;
        explain(result, frame);
        if (frame.obstacle == Obstacle::Locked) locate(result, config + full * (target - config));
        return;
      }
      accept(frame, next);
      step = std::min(full, 2 * step);
      run_.report("folding", std::lround(1000 * next), 1000);
    }
    result.ending = Ending::Found;
  }

  // The first frame from flat in which every crease turns to its side, or else one in which none turns to the wrong.
  std::optional<Frame> leave_flat(ContinuationResult& result) {
    const Configuration start = Configuration::Zero(groups_.size());
    std::optional<Frame> fallback;
    double fallback_step = 0;
    for (const Configuration& direction : {goal_, half_tangents(goal_)})
      for (double scale : {1.0, 0.3, 3.0, 10.0}) {
        first_step_ = scale * options_.first_step;
        if (first_step_ >= 1 || run_.over()) continue;
        Frame frame = try_frame(result, start, first_step_ * direction, first_step_ * direction);
        if (frame.obstacle != Obstacle::None) continue;
        frame.guess = first_step_ * goal_;
        if (turns_every_crease(frame.projection.config)) return frame;
        if (fallback) continue;
        fallback = std::move(frame);
        fallback_step = first_step_;
      }
    first_step_ = fallback_step;
    return fallback;
  }

  bool turns_every_crease(const Configuration& config) const {
    for (int h = 0; h < config.size(); ++h)
      if (std::abs(goal_[h]) > kSignTolerance && config[h] / goal_[h] < 0.05 * first_step_) return false;
    return true;
  }

  Frame try_frame(ContinuationResult& result, const Configuration& from, const Configuration& straight,
                  const Configuration& guess) {
    Frame frame;
    frame.guess = straight;
    ProjectOptions projection = projection_;
    if (guess == goal_) projection.tolerance = std::max(projection.tolerance, kGoalTolerance);  // it closes already
    frame.projection = projector_.project(guess, projection, run_);
    result.steps += frame.projection.steps;
    const Configuration& to = frame.projection.config;
    int farthest = -1;
    const double move = to.size() ? (to - from).cwiseAbs().maxCoeff(&farthest) : 0;
    if (!frame.projection.closed || move > options_.max_move) {
      frame.obstacle = Obstacle::Locked;
      frame.hinge = frame.projection.closed ? farthest : -1;
    } else if (const int h = wrong_side(to); h >= 0) {
      frame.obstacle = Obstacle::WrongSide;
      frame.hinge = h;
    } else if (options_.check_collisions && checker_.collides(groups_.expand(to))) {
      frame.obstacle = Obstacle::Collision;
      frame.panels = checker_.collisions(groups_.expand(to)).front();
    }
    return frame;
  }

  int wrong_side(const Configuration& config) const {
    for (int h = 0; h < config.size(); ++h)
      if ((goal_[h] > 0 && config[h] < -kSignTolerance) || (goal_[h] < 0 && config[h] > kSignTolerance)) return h;
    return -1;
  }

  void explain(ContinuationResult& result, const Frame& frame) const {
    result.obstacle = frame.obstacle;
    result.hinge = frame.hinge < 0 ? -1 : groups_.first(frame.hinge);
    result.panels = frame.panels;
    if (frame.obstacle == Obstacle::WrongSide && !vertices_of_[frame.hinge].empty())
      result.vertex = vertices_of_[frame.hinge].front();
  }

  void locate(ContinuationResult& result, const Configuration& step) const {
    const Closure opened = closure(projector_.vertices(), step);
    result.vertex = opened.worst_vertex;
    result.residual = opened.worst;
  }

  const ContinuationOptions& options_;
  const Run& run_;
  Groups groups_;
  Projector projector_;
  ProjectOptions projection_;
  Configuration goal_;
  CollisionChecker checker_;
  std::vector<std::vector<int>> vertices_of_;  // real ones, of each group
  double first_step_ = 0;
};

}  // namespace

std::string_view name(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::None:
      return "none";
    case Obstacle::GoalOpen:
      return "goal-open";
    case Obstacle::Locked:
      return "locked";
    case Obstacle::WrongSide:
      return "wrong-side";
    case Obstacle::Collision:
      return "collision";
  }
  return "none";
}

std::string describe(const Linkage& linkage, const ContinuationResult& result) {
  const std::string where = fmt::format("{:.3g} %", 100 * result.progress);
  switch (result.obstacle) {
    case Obstacle::None:
      return {};
    case Obstacle::GoalOpen:
      return fmt::format("not rigid: the goal stays open by {:.3g} rad at {}", result.residual,
                         tell_vertex(linkage, result.vertex));
    case Obstacle::Locked:
      if (result.hinge >= 0)
        return fmt::format("locked at {} of the way: {} would have to jump", where, tell_hinge(linkage, result.hinge));
      return fmt::format("not rigid: locked at {} of the way; going on opens {} by {:.3g} rad", where,
                         tell_vertex(linkage, result.vertex), result.residual);
    case Obstacle::WrongSide:
      return fmt::format("left the branch at {} of the way: {} would turn against its goal", where,
                         tell_hinge(linkage, result.hinge));
    case Obstacle::Collision:
      return fmt::format("collides after {} of the way, in frame {}: panels {}, {}", where,
                         result.path.waypoints.size(), result.panels.a, result.panels.b);
  }
  return {};
}

ContinuationResult continue_to_goal(const Linkage& linkage, const ContinuationOptions& options, const Run& run) {
  check(options);
  require_closable(linkage);
  return Continuation(linkage, options, run).plan();
}

}  // namespace plico
