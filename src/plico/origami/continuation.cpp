#include "plico/origami/continuation.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr double kSignTolerance = 1e-7;  // radians: noise of a crease that is flat at the moment

void check(const ContinuationOptions& o) {
  if (o.frames < 1) throw InvalidOption(fmt::format("frames = {} must be at least 1", o.frames));
  if (!(o.min_progress > 0)) throw InvalidOption(fmt::format("min progress = {} must be above 0", o.min_progress));
  if (!(o.max_move > 0)) throw InvalidOption(fmt::format("max move = {} must be above 0", o.max_move));
}

// What stood in the way of one frame.
struct Frame {
  Obstacle obstacle = Obstacle::None;
  Projection projection;
  int hinge = -1;
  PanelPair panels;
};

class Continuation {
 public:
  Continuation(const CreasePattern& sheet, const ContinuationOptions& options)
      : options_(options),
        linkage_(make_linkage(sheet)),
        vertices_(real_vertices(sheet)),
        goal_(goal(linkage_)),
        checker_(linkage_, options.collision) {}

  ContinuationResult run(const Run& run) {
    ContinuationResult result;
    Configuration config = flat(linkage_);
    result.path.waypoints.push_back({0, config});
    const Closure at_goal = closure(vertices_, goal_);
    if (at_goal.worst > 1e-9) {
      result.obstacle = Obstacle::GoalOpen;
      result.vertex = at_goal.worst_vertex;
      result.residual = at_goal.worst;
      return result;
    }
    const double full = 1.0 / options_.frames;
    double step = full;
    while (result.progress < 1) {
      if (run.over()) {
        result.ending = run.ending();
        return result;
      }
      const double next = result.progress + step > 1 - 1e-12 ? 1 : result.progress + step;
      const Frame frame = try_frame(config, (next - result.progress) / (1 - result.progress), next == 1);
      if (frame.obstacle != Obstacle::None) {
        step /= 2;
        if (step >= options_.min_progress) continue;
        explain(result, frame);
        return result;
      }
      config = frame.projection.config;
      result.worst_residual = std::max(result.worst_residual, frame.projection.closure.worst);
      result.progress = next;
      result.path.waypoints.push_back({next, config});
      step = std::min(full, 2 * step);
      run.report("folding", std::lround(1000 * next), 1000);
    }
    result.ending = Ending::Found;
    return result;
  }

 private:
  // The last frame is the goal itself, which closes.
  Frame try_frame(const Configuration& from, double share, bool last) {
    Frame frame;
    ProjectOptions projection = options_.projection;
    if (last) projection.tolerance = std::max(projection.tolerance, 1e-9);
    frame.projection = project(vertices_, last ? goal_ : Configuration(from + share * (goal_ - from)), projection);
    const Configuration& to = frame.projection.config;
    int farthest = -1;
    const double move = to.size() ? (to - from).cwiseAbs().maxCoeff(&farthest) : 0;
    if (!frame.projection.closed || move > options_.max_move) {
      frame.obstacle = Obstacle::Locked;
      frame.hinge = frame.projection.closed ? farthest : -1;
      return frame;
    }
    for (int h = 0; h < to.size(); ++h)
      if ((goal_[h] > 0 && to[h] < -kSignTolerance) || (goal_[h] < 0 && to[h] > kSignTolerance)) {
        frame.obstacle = Obstacle::WrongSide;
        frame.hinge = h;
        return frame;
      }
    if (options_.check_collisions && checker_.collides(to)) {
      frame.obstacle = Obstacle::Collision;
      frame.panels = checker_.collisions(to).front();
    }
    return frame;
  }

  static void explain(ContinuationResult& result, const Frame& frame) {
    result.obstacle = frame.obstacle;
    result.hinge = frame.hinge;
    result.panels = frame.panels;
    if (frame.obstacle != Obstacle::Locked) return;
    result.vertex = frame.projection.closure.worst_vertex;
    result.residual = frame.projection.closure.worst;
  }

  const ContinuationOptions& options_;
  Linkage linkage_;
  std::vector<RealVertex> vertices_;
  Configuration goal_;
  CollisionChecker checker_;
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

ContinuationResult continue_to_goal(const CreasePattern& sheet, const ContinuationOptions& options, const Run& run) {
  check(options);
  return Continuation(sheet, options).run(run);
}

}  // namespace plico
