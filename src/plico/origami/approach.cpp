#include "plico/origami/approach.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "plico/base/error.h"
#include "plico/motion/contacts.h"

namespace plico {
namespace {

constexpr double kThere = 1e-9;      // radians: a goal that closes, and one that is reached
constexpr double kFirstMove = 0.03;  // of the goal: the step that leaves flat
constexpr int kContactRounds = 8;    // in which one step may meet more panels
constexpr int kSweeps = 200;         // of Gauss-Seidel
constexpr double kNoPush = 1e-14;    // of the largest push
constexpr int kMostSteps = 20;       // of a projection once flat is left: what needs more will not be near
constexpr std::size_t kCreepLength = 100, kCreepLooks = 10;  // waypoints
constexpr double kCreepGain = 0.004;                         // of the squared distance
constexpr double kLeastTurn = 1e-5;                          // radians: a first step that turns less has not left flat

void check(const ApproachOptions& o) {
  require(o.frames >= 1, "frames", o.frames, "at least 1");
  require(o.facet_weight > 0, "facet weight", o.facet_weight, "above 0");
  require(o.min_move > 0, "min move", o.min_move, "above 0");
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
  require(o.damping > 0, "damping", o.damping, "above 0");
  require(o.max_waypoints >= 1, "max waypoints", o.max_waypoints, "at least 1");
}

class Approach {
 public:
  Approach(const Linkage& linkage, const ApproachOptions& options, const Run& run)
      : options_(options),
        run_(run),
        linkage_(linkage),
        goal_(goal(linkage_)),
        projector_(linkage),
        checker_(linkage_, options.collision),
        plates_(make_plates(linkage, checker_.clearance())),
        margin_(0.5 * checker_.clearance()),
        reach_(0.5 * mean_side_length(linkage)),
        max_move_(kPi / options.frames) {
    const int creases = linkage_.num_hinges();
    projection_.low.resize(creases);
    projection_.high.resize(creases);
    projection_.weight.resize(creases);
    projection_.tolerance = options.tolerance;
    projection_.damping = options.damping;
    for (int h = 0; h < creases; ++h) set_crease(h);
    goal_ = goal_.cwiseMax(projection_.low).cwiseMin(projection_.high);
    goal_closes_ = closure(projector_.vertices(), goal_).worst <= std::max(kThere, options.tolerance);
  }

  ContinuationResult descend(const FoldingPath& begun) {
    ContinuationResult result;
    result.path = begun;
    if (begun.waypoints.size() < 2) {
      result.path.waypoints = {{0, flat(linkage_)}};
      if (!leave_flat(result)) return finish(result);
    }
    projection_.max_steps = kMostSteps;
    while (distance(end(result)) > 0) {
      if (run_.over()) {
        result.ending = run_.ending();
        return finish(result);
      }
      if (static_cast<int>(result.path.waypoints.size()) >= options_.max_waypoints) return finish(result);
      if (!step(result)) return finish(result);
      if (creeps(result.path, begun.waypoints.size())) {
        if (result.obstacle != Obstacle::Collision) stand_still(result);
        return finish(result);
      }
      run_.report("folding", std::lround(1000 * share_of_way(linkage_, end(result))), 1000);
    }
    result.ending = Ending::Found;
    result.obstacle = Obstacle::None;
    return finish(result);
  }

 private:
  void set_crease(int h) {
    const Hinge& hinge = linkage_.hinges[h];
    projection_.low[h] = options_.keep_sides && hinge.target > 0 ? std::max(0.0, hinge.low) : hinge.low;
    projection_.high[h] = options_.keep_sides && hinge.target < 0 ? std::min(0.0, hinge.high) : hinge.high;
    projection_.weight[h] = hinge.target == 0 ? options_.facet_weight : 1;
    if (options_.emphasis.size() > 0) projection_.weight[h] *= options_.emphasis[h];
  }

  static const Configuration& end(const ContinuationResult& result) { return result.path.waypoints.back().config; }

  // Weighted, squared: what descends. 0 exactly at the goal.
  double distance(const Configuration& config) const {
    return (goal_ - config).cwiseAbs2().cwiseProduct(projection_.weight).sum();
  }

  // Of several first steps the one that comes nearest to the goal.
  bool leave_flat(ContinuationResult& result) {
    const Configuration tangents = (goal_.array().min(0.99 * kPi).max(-0.99 * kPi) / 2).tan().matrix();
    const double longest = tangents.cwiseAbs().maxCoeff();
    if (!(longest > 0)) return false;
    std::optional<Configuration> best;
    for (const Configuration& direction : {goal_, Configuration(kPi / longest * tangents)})
      for (double scale : {1.0, 0.3, 3.0}) {
        std::optional<Configuration> first = frame(result, end(result), scale * kFirstMove * direction, 2 * max_move_);
        if (first && (!best || distance(*first) < distance(*best))) best = std::move(first);
      }
    if (!best || (*best).cwiseAbs().maxCoeff() < kLeastTurn) {
      if (result.obstacle != Obstacle::Collision) stand_still(result);
      return false;
    }
    result.path.waypoints.push_back({0, std::move(*best)});
    return true;
  }

  bool step(ContinuationResult& result) {
    const Configuration at = end(result), rest = goal_ - at;
    if (goal_closes_ && rest.cwiseAbs().maxCoeff() <= max_move_)
      if (std::optional<Configuration> last = frame(result, at, goal_, max_move_)) {
        result.path.waypoints.push_back({0, goal_});
        return true;
      }
    result.obstacle = Obstacle::None;
    Configuration way = way_apart(at, rest, max_move_);
    double most = max_move_;
    for (int round = 0; std::min(most, way.cwiseAbs().maxCoeff()) > options_.min_move; ++round) {
      const double turn = way.cwiseAbs().maxCoeff(), move = std::min(turn, most);
      std::optional<Configuration> next = frame(result, at, at + move / turn * way, 2 * move);
      if (next && (*next - at).cwiseAbs().maxCoeff() >= options_.min_move / 2) {
        result.path.waypoints.push_back({0, std::move(*next)});
        return true;
      }
      if (next || round >= kContactRounds || !meets_more()) {
        most = move / 2;
        round = 0;
        colliding_.clear();
        if (near_.empty()) continue;
      }
      way = way_apart(at, rest, most);
    }
    if (result.obstacle != Obstacle::Collision) stand_still(result);
    return false;
  }

  // Hardly nearer to the goal than many waypoints ago.
  bool creeps(const FoldingPath& path, std::size_t begun) const {
    const std::size_t length = path.waypoints.size();
    if (length % kCreepLooks != 0 || length <= begun + kCreepLength) return false;
    const double before = distance(path.waypoints[length - 1 - kCreepLength].config);
    return distance(path.waypoints.back().config) > (1 - kCreepGain) * before;
  }

  // The pairs that collided in the last frame join those to be kept apart; true when there are new ones.
  bool meets_more() {
    const std::size_t before = near_.size();
    near_.insert(colliding_.begin(), colliding_.end());
    colliding_.clear();
    return near_.size() > before;
  }

  // The way to the goal that keeps loops closed to first order, and panels that are near each other apart: of the
  // smallest weighted distance from the straight one. `most` is how far a crease will turn, radians.
  Configuration way_apart(const Configuration& at, const Configuration& rest, double most) {
    near_.insert(options_.watched.begin(), options_.watched.end());
    const std::vector<PanelPair> pairs(near_.begin(), near_.end());
    std::vector<Contact> met = contacts(linkage_, plates_, at, pairs, reach_);
    near_.clear();
    for (const Contact& contact : met) near_.insert(contact.panels);
    const int count = static_cast<int>(met.size());
    Eigen::MatrixXd directions(at.size(), 1 + count), slopes(at.size(), count);
    directions.col(0) = rest;
    for (int i = 0; i < count; ++i) {
      slopes.col(i) = met[i].slope;
      directions.col(1 + i) = met[i].slope.cwiseQuotient(projection_.weight);
    }
    const Eigen::MatrixXd tangents = projector_.tangents(at, directions, projection_);
    const Configuration way = tangents.col(0);
    if (count == 0) return way;
    const double share = std::min(1.0, most / std::max(kLeastTurn, way.cwiseAbs().maxCoeff()));
    Eigen::VectorXd lacking = -(slopes.transpose() * way);
    for (int i = 0; i < count; ++i) lacking[i] -= (met[i].apart - margin_) / share;
    const Eigen::MatrixXd pushes = tangents.rightCols(count);
    return way + pushes * multipliers(slopes.transpose() * pushes, lacking);
  }

  // x >= 0 with kept * x >= lacking, and equal where x > 0, by projected Gauss-Seidel.
  static Eigen::VectorXd multipliers(const Eigen::MatrixXd& kept, const Eigen::VectorXd& lacking) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(lacking.size());
    const double least = kNoPush * kept.cwiseAbs().maxCoeff();  // a contact that no way to fold can part
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (int i = 0; i < x.size(); ++i)
        if (kept(i, i) > least) x[i] = std::max(0.0, x[i] + (lacking[i] - kept.row(i).dot(x)) / kept(i, i));
    return x;
  }

  // The foldable configuration near `guess` if it may follow `from`.
  std::optional<Configuration> frame(ContinuationResult& result, const Configuration& from, const Configuration& guess,
                                     double most) {
    Projection found = projector_.project(guess, projection_, run_);
    result.steps += found.steps;
    if (found.closure.worst > std::max(kThere, options_.tolerance) ||
        (found.config - from).cwiseAbs().maxCoeff() > most)
      return {};
    if (!(distance(found.config) < distance(from))) return {};
    if (options_.accepts && !options_.accepts(found.config)) return {};
    if (options_.check_collisions && checker_.collides(found.config)) {
      result.obstacle = Obstacle::Collision;
      colliding_ = checker_.collisions(found.config);
      result.panels = colliding_.front();
      return {};
    }
    PLICO_ASSERT(hinge_beyond_limits(linkage_, found.config) < 0);
    result.worst_residual = std::max(result.worst_residual, found.closure.worst);
    return std::move(found.config);
  }

  // Where going straight on would open the sheet most.
  void stand_still(ContinuationResult& result) const {
    result.obstacle = goal_closes_ ? Obstacle::Locked : Obstacle::GoalOpen;
    const Configuration& at = end(result);
    const Closure opened = closure(projector_.vertices(), goal_closes_ ? at + 0.1 * (goal_ - at) : goal_);
    result.vertex = opened.worst_vertex;
    result.residual = opened.worst;
  }

  ContinuationResult finish(ContinuationResult& result) const {
    double length = 0;
    std::vector<Waypoint>& waypoints = result.path.waypoints;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
      if (i > 0) length += (waypoints[i].config - waypoints[i - 1].config).norm();
      waypoints[i].time = length;
    }
    if (length > 0)
      for (Waypoint& waypoint : waypoints) waypoint.time /= length;
    result.progress = share_of_way(linkage_, waypoints.back().config);
    return std::move(result);
  }

  const ApproachOptions& options_;
  const Run& run_;
  const Linkage& linkage_;
  Configuration goal_;
  Projector projector_;
  CollisionChecker checker_;
  Plates plates_;
  double margin_, reach_;  // units: what is to be between panels that are near each other; farther is not near
  std::set<PanelPair> near_;
  std::vector<PanelPair> colliding_;  // in the last frame
  double max_move_;
  ProjectOptions projection_;
  bool goal_closes_ = false;
};

}  // namespace

ContinuationResult approach_goal(const Linkage& linkage, const FoldingPath& begun, const ApproachOptions& options,
                                 const Run& run) {
  check(options);
  require_closable(linkage);
  return Approach(linkage, options, run).descend(begun);
}

}  // namespace plico
