#include "plico/workflow/plan_origami.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plico/base/error.h"
#include "plico/origami/continuation.h"
#include "plico/origami/crease_groups.h"
#include "plico/origami/md_frog.h"
#include "plico/origami/reuse.h"
#include "plico/workflow/far_motion.h"

namespace plico {
namespace {

constexpr double kGapShare = 0.2;     // of the clearance, that hinges may open by between waypoints
constexpr int kMostPieces = 64;       // that one step is cut into at once
constexpr int kRefinements = 3;       // the first does nearly all; the others meet steps that were not straight
constexpr int kMostSteps = 20;        // of a projection at once
constexpr double kTreeTime = 0.5;     // of what is left, for the planners of sheets without loops
constexpr double kClosed = 1e-9;      // radians, of every waypoint
constexpr double kLimitSlack = 1e-9;  // radians
constexpr double kOvershoot = 10;     // times what a goal may move: a search that strays farther will not come back
constexpr int kMostLimitedNamed = 3;
constexpr int kMostCreasesNamed = 4;
constexpr int kMostCreasesSearched = 64;  // without being asked: the number of discrete states grows exponentially

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

void scale_times(FoldingPath& path) {
  const double last = path.waypoints.back().time;
  for (Waypoint& w : path.waypoints) w.time /= last;
  path.waypoints.back().time = 1;
}

void check(const MotionOptions& options) {
  const MotionMethod method = options.method;
  if (method == MotionMethod::Reuse) throw InvalidOption("reuse is no planner: it carries a motion over");
  if (!contract(method).loops)
    throw InvalidOption(
        fmt::format("{} is for sheets without loops; try auto, continuation, frog or md-frog", name(method)));
  if (!options.through.empty() && method != MotionMethod::Auto && method != MotionMethod::MdFrog)
    throw InvalidOption(fmt::format("{} does not pass given states; md-frog does", name(method)));
  if (options.grouped && method == MotionMethod::Frog)
    throw InvalidOption("frog moves every crease by itself; continuation and md-frog plan in groups");
}

class OrigamiPlanning {
 public:
  // Panels are cut by flat creases only where the sheet is given that the linkage was made from.
  OrigamiPlanning(Linkage linkage, std::optional<CreasePattern> sheet, const MotionOptions& options, const Run& run)
      : linkage_(std::move(linkage)), sheet_(std::move(sheet)), options_(options), run_(run), planned_(&linkage_) {
    clearance_ = options.clearance > 0 ? options.clearance : default_clearance(linkage_);
  }

  MotionOutcome plan() {
    close_goal();
    if (options_.grouped) groups_ = crease_groups(linkage_);
    switch (options_.method) {
      case MotionMethod::Frog:
        walk_randomly();
        break;
      case MotionMethod::MdFrog:
        search_states();
        break;
      default:
        if (options_.through.empty())
          continue_straight(options_.method == MotionMethod::Auto);
        else
          search_states();
    }
    return finish();
  }

  MotionOutcome carry(const Linkage& small, const FoldingPath& path) {
    const FoldingPath carried = reuse_path(small, path, linkage_);
    const double rest = (carried.waypoints.back().config - goal(linkage_)).lpNorm<Eigen::Infinity>();
    goal_within_limits();
    outcome_.ending = rest <= kMostGoalMove ? Ending::Found : Ending::Exhausted;
    if (rest > kMostGoalMove)
      outcome_.notes.push_back(fmt::format("the motion given ends {:.3g} degrees short of the goal", degrees(rest)));
    prove(carried, MotionMethod::Reuse);
    return finish();
  }

 private:
  MotionOutcome finish() {
    if (run_.over() && !outcome_.proven()) outcome_.ending = run_.ending();
    const bool enough = static_cast<int>(outcome_.motions.size()) >= options_.alternatives;
    if (outcome_.ending == Ending::Found && !enough) outcome_.ending = Ending::Exhausted;
    return std::move(outcome_);
  }

  // What is blocked on the straight way may be folded in another order: one crease after the other.
  void continue_straight(bool may_go_round) {
    const bool within = goal_within_limits();
    ContinuationOptions continuation;
    continuation.frames = options_.waypoints;
    continuation.collision.clearance = options_.clearance;
    if (!within) plan_without_limits();
    const ContinuationResult found =
        groups_ ? continue_in_groups(continuation) : continue_to_goal(*planned_, continuation, run_);
    outcome_.ending = found.ending;
    outcome_.progress = found.progress;
    if (const std::string note = describe(linkage_, found); !note.empty()) outcome_.notes.push_back(note);
    if (found.ending == Ending::Found) prove(found.path, MotionMethod::Continuation);
    if (outcome_.proven() && within && may_go_round && options_.alternatives > 1) return look_for_alternatives();
    const bool blocked = found.obstacle != Obstacle::None && found.obstacle != Obstacle::GoalOpen;
    const bool refuted = found.ending == Ending::Found && !outcome_.proven();
    if (may_go_round && within && (blocked || refuted) && !goal_collides() && !run_.over()) {
      if (linkage_.num_hinges() <= kMostCreasesSearched && search_states()) return;
      if (linkage_.num_hinges() > kMostCreasesSearched)
        outcome_.notes.push_back(fmt::format("{} creases are many for a search of other ways; --planner md-frog tries",
                                             linkage_.num_hinges()));
    }
    if (within && !groups_ && !run_.over()) {
      if (found.ending != Ending::Found || !outcome_.proven()) go_on_from(found.path);
    } else if (found.ending != Ending::Found && found.path.waypoints.size() > 1) {
      prove(found.path, MotionMethod::Continuation);
    }
  }

  // One way straight to the goal is not several; others go through discrete states.
  void look_for_alternatives() {
    const MotionOutcome straight = outcome_;
    if (linkage_.num_hinges() <= kMostCreasesSearched) {
      search_states();
    } else {
      outcome_.notes.push_back(fmt::format("{} creases are many for a search of other ways; --planner md-frog tries",
                                           linkage_.num_hinges()));
    }
    if (!outcome_.proven()) outcome_ = straight;
  }

  // A goal beyond the limits is still where the way leads, to be left where the material ends (keep_limits).
  void plan_without_limits() {
    unlimited_ = linkage_;
    for (Hinge& hinge : unlimited_->hinges) hinge.low = -kPi, hinge.high = kPi;
    planned_ = &*unlimited_;
  }

  // What does not reach the goal still leads as far as the sheet goes.
  void go_on_from(const FoldingPath& begun) {
    FarMotion far = go_as_far(linkage_, sheet_ ? &*sheet_ : nullptr, begun, options_, run_);
    outcome_.notes.insert(outcome_.notes.end(), far.notes.begin(), far.notes.end());
    outcome_.progress = far.share;
    outcome_.ending = far.reached ? Ending::Found : Ending::Exhausted;
    if (far.motion.path.waypoints.size() < 2) {
      if (far.timed_out) outcome_.ending = Ending::TimedOut;
      return;
    }
    outcome_.motions = {std::move(far.motion)};
    outcome_.sheet = std::move(far.sheet);
    outcome_.bends = std::move(far.bends);
  }

  // Waypoints that are inserted later close every loop, but groups need not move alike there. So here, where they do,
  // frames come close enough.
  ContinuationResult continue_in_groups(ContinuationOptions& continuation) {
    continuation.groups = groups_->group;
    continuation.essential = groups_->essential;
    outcome_.notes.push_back(fmt::format("planned with {} crease groups and {} of {} vertices", groups_->num_moving,
                                         groups_->essential.size(), groups_->type.size()));
    ContinuationResult found = continue_to_goal(*planned_, continuation, run_);
    if (found.path.waypoints.size() < 2) return found;
    FoldingPath reached = found.path;
    scale_times(reached);  // a path that ends early is a motion all the same
    const double gap = SheetMotion(linkage_, reached).loops().gap;
    const double finer = std::ceil(1.1 * std::sqrt(gap / (kGapShare * clearance_)));
    if (finer <= 1) return found;
    continuation.frames = static_cast<int>(std::min(1e6, finer * continuation.frames));
    return continue_to_goal(*planned_, continuation, run_);
  }

  // Then no way leads there.
  bool goal_collides() {
    const std::vector<PanelPair> pairs =
        CollisionChecker(linkage_, {.clearance = options_.clearance}).collisions(goal(linkage_));
    if (pairs.empty()) return false;
    outcome_.ending = Ending::Exhausted;
    outcome_.notes.push_back(
        fmt::format("the goal collides with itself: panels {}, {}", pairs.front().a, pairs.front().b));
    return true;
  }

  void walk_randomly() {
    if (!goal_within_limits()) return stay_flat();
    if (goal_collides()) return;
    FrogOptions frog;
    frog.seed = options_.seed;
    frog.collision.clearance = options_.clearance;
    const FrogResult found = plico::frog(linkage_, frog, run_);
    outcome_.ending = found.ending;
    const double whole = goal(linkage_).norm();
    outcome_.progress = whole > 0 ? 1 - found.distance / whole : 1;
    if (found.ending == Ending::Exhausted)
      outcome_.notes.push_back(
          fmt::format("FROG stopped after {} samples, {:.3g} rad from the goal", found.counts.sampled, found.distance));
    if (found.path.waypoints.size() > 1) prove(found.path, MotionMethod::Frog);
  }

  void stay_flat() {
    outcome_.ending = Ending::Exhausted;
    outcome_.progress = 0;
  }

  // Through discrete states; a path that the proof refutes costs one connection. True when there is a proven motion.
  bool search_states() {
    if (closure(linkage_.loops, goal(linkage_)).worst > 1e-9) {
      outcome_.ending = Ending::Exhausted;
      outcome_.notes.emplace_back("not rigid: the goal does not close");
      return false;
    }
    const bool goes_straight_first = options_.method == MotionMethod::Auto && options_.through.empty();
    if (!goes_straight_first && !goal_within_limits()) {
      stay_flat();
      return false;
    }
    if (options_.method == MotionMethod::MdFrog && goal_collides()) return false;
    MdFrogOptions options;
    options.frog.seed = options_.seed;
    options.frog.collision.clearance = options_.clearance;
    options.alternatives = options_.alternatives;
    options.intermediate = options_.through;
    if (groups_) options.discrete.groups = groups_->group;
    options.refute = [&](const FoldingPath& path) { return refute(path); };
    const MdFrogResult found = md_frog(linkage_, options, run_);
    if (found.paths.empty()) {
      if (outcome_.motions.empty()) outcome_.ending = found.ending;
      const std::string tried = fmt::format("{} discrete states: {} connections tried, {} ways refuted by the proof",
                                            found.states, found.connections_tried, found.refuted);
      outcome_.notes.push_back(found.ending == Ending::Exhausted
                                   ? fmt::format("no {}way through {}", outcome_.notes.empty() ? "" : "other ", tried)
                                   : "the search for a way was cut short among " + tried);
      return false;
    }
    outcome_ = {};
    outcome_.ending = found.ending;
    outcome_.progress = 1;
    for (const MdFrogPath& path : found.paths) prove(path.path, MotionMethod::MdFrog);
    outcome_.notes.push_back(told(found.paths.front()));
    return outcome_.proven();
  }

  // The time at which the proof stops.
  std::optional<double> refute(const FoldingPath& path) const {
    const FoldingPath fine = refine_path(linkage_, path, kGapShare * clearance_, run_);
    const PathProof proof = prove_path(linkage_, fine, {.clearance = options_.clearance}, run_);
    if (proof.verdict == PathVerdict::Free) return {};
    return (proof.from + proof.to) / 2;
  }

  // The creases that turn between one state and the next.
  std::string told(const MdFrogPath& path) const {
    std::string steps;
    for (std::size_t i = 1; i < path.states.size(); ++i) {
      std::string creases;
      int count = 0;
      for (int h = 0; h < path.states[i].size(); ++h) {
        if (std::abs(path.states[i][h] - path.states[i - 1][h]) < kLimitSlack) continue;
        if (++count <= kMostCreasesNamed)
          creases += fmt::format("{}{}", count > 1 ? ", " : "", linkage_.hinges[h].edge);
      }
      const bool all_named = count <= kMostCreasesNamed;
      steps += fmt::format("{}{} crease{}{}", i > 1 ? ", then " : "", count, count == 1 ? "" : "s",
                           all_named ? fmt::format(" ({})", creases) : "");
    }
    return fmt::format("folding order: {}", steps);
  }

  // Angles in files are often rounded; what is nearly closed is meant to be closed.
  void close_goal() {
    const Configuration wanted = goal(linkage_);
    Projector projector(linkage_);
    if (closure(projector.vertices(), wanted).worst <= 1e-9) return;
    const Projection projection = projector.project(wanted, {.most_turn = kOvershoot * kMostGoalMove}, run_);
    const double move = (projection.config - wanted).cwiseAbs().maxCoeff();
    if (!projection.closed || move > kMostGoalMove) return;
    for (int h = 0; h < linkage_.num_hinges(); ++h) {
      linkage_.hinges[h].target = projection.config[h];
      if (sheet_) sheet_->edges[linkage_.hinges[h].edge].fold_angle = projection.config[h];
    }
    outcome_.notes.push_back(
        fmt::format("goal angles moved by up to {:.3g} degrees so that they close", degrees(move)));
  }

  bool goal_within_limits() {
    std::vector<int> beyond;
    const Configuration target = goal(linkage_);
    for (int h = 0; h < linkage_.num_hinges(); ++h)
      if (target[h] < linkage_.hinges[h].low - kLimitSlack || target[h] > linkage_.hinges[h].high + kLimitSlack)
        beyond.push_back(h);
    if (beyond.empty()) return true;
    std::string creases;
    for (std::size_t i = 0; i < beyond.size() && i < kMostLimitedNamed; ++i)
      creases += (i ? ", " : "") + tell_hinge(linkage_, beyond[i]);
    const Hinge& first = linkage_.hinges[beyond.front()];
    outcome_.notes.push_back(fmt::format(
        "limited: the goal folds {} crease{} beyond the material, the first to {:.4g} degrees, {:.4g} allowed: {}{}",
        beyond.size(), beyond.size() == 1 ? "" : "s", degrees(std::abs(first.target)),
        degrees(std::abs(first.target > 0 ? first.high : first.low)), creases,
        beyond.size() > kMostLimitedNamed ? ", ..." : ""));
    return false;
  }

  // Ends the path before its first waypoint beyond the limits, and tells which crease ends it.
  void keep_limits(FoldingPath& path) {
    const auto beyond = std::find_if(path.waypoints.begin(), path.waypoints.end(), [&](const Waypoint& w) {
      return hinge_beyond_limits(linkage_, w.config, kLimitSlack) >= 0;
    });
    if (beyond == path.waypoints.end()) return;
    outcome_.notes.push_back(
        fmt::format("limited: at {} of the way {} would turn beyond the material", percent(beyond->time),
                    tell_hinge(linkage_, hinge_beyond_limits(linkage_, beyond->config, kLimitSlack))));
    path.waypoints.erase(beyond, path.waypoints.end());
    outcome_.ending = Ending::Exhausted;
    outcome_.progress = path.waypoints.empty() ? 0 : path.waypoints.back().time;
  }

  void prove(const FoldingPath& planned, MotionMethod method) {
    FoldingPath path = planned;
    const double reached = path.waypoints.back().time;
    scale_times(path);
    path = refine_path(*planned_, path, kGapShare * clearance_, run_);
    for (Waypoint& w : path.waypoints) w.time *= reached;
    keep_limits(path);
    if (path.waypoints.size() < 2) return;
    scale_times(path);
    Motion motion{method, std::move(path), {}};
    motion.proof = prove_path(linkage_, motion.path, {.clearance = options_.clearance}, run_);
    if (motion.proof.verdict != PathVerdict::Free && outcome_.ending == Ending::Found)
      outcome_.ending = Ending::Exhausted;
    outcome_.motions.push_back(std::move(motion));
  }

  Linkage linkage_;
  std::optional<CreasePattern> sheet_;
  const MotionOptions& options_;
  const Run& run_;
  std::optional<Linkage> unlimited_;
  const Linkage* planned_;  // one of the two
  std::optional<CreaseGroups> groups_;
  double clearance_ = 0;
  MotionOutcome outcome_;
};

// Waypoints strictly between two, or none when the sheet does not close near the straight line.
std::vector<Waypoint> between(Projector& projector, const ProjectOptions& within, const Waypoint& a, const Waypoint& b,
                              int pieces, double closed, const Run& run) {
  std::vector<Waypoint> inserted;
  const double most = 0.5 * (b.config - a.config).cwiseAbs().maxCoeff();
  for (int i = 1; i < pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const Configuration straight = (1 - share) * a.config + share * b.config;
    // Near singular states the last digits cost dozens of steps and are not needed.
    Projection projection = projector.project(straight, within, run);
    if (projection.closure.worst > closed) projection = projector.project(projection.config, within, run);
    if (projection.closure.worst > closed || (projection.config - straight).cwiseAbs().maxCoeff() > most) return {};
    inserted.push_back({(1 - share) * a.time + share * b.time, std::move(projection.config)});
  }
  return inserted;
}

}  // namespace

FoldingPath refine_path(const Linkage& linkage, const FoldingPath& path, double gap, const Run& run, double closed) {
  require(gap > 0, "gap", gap, "above 0");
  Projector projector(linkage);
  ProjectOptions within{.low = lower_limits(linkage), .high = upper_limits(linkage)};
  within.max_steps = kMostSteps;
  if (closed > kClosed) within.tolerance = closed, within.damping = std::max(within.damping, closed / 100);
  FoldingPath refined = path;
  for (int i = 0; i < kRefinements; ++i) {
    const SheetMotion motion(linkage, refined);
    if (motion.loops().gap <= gap) break;
    FoldingPath next;
    const std::vector<Waypoint>& old = refined.waypoints;
    for (std::size_t w = 0; w < old.size(); ++w) {
      next.waypoints.push_back(old[w]);
      if (w + 1 == old.size() || motion.gap_after(static_cast<int>(w)) <= gap || run.over()) continue;
      const int pieces = std::min(
          kMostPieces, static_cast<int>(std::ceil(std::sqrt(1.05 * motion.gap_after(static_cast<int>(w)) / gap))));
      for (Waypoint& inserted : between(projector, within, old[w], old[w + 1], pieces, std::max(closed, kClosed), run))
        next.waypoints.push_back(std::move(inserted));
    }
    if (next.waypoints.size() == old.size()) break;
    refined = std::move(next);
  }
  return refined;
}

MotionOutcome plan_loops(const Linkage& linkage, const MotionOptions& options, const Run& run) {
  check(options);
  return OrigamiPlanning(linkage, {}, options, run).plan();
}

namespace {

// What no planner folds to the goal still goes as far as it can.
MotionOutcome fold_tree(const Linkage& linkage, const MotionOptions& options, const Run& run) {
  MotionOutcome outcome = plan(linkage, options, share_of_time(run, kTreeTime));
  if (outcome.proven() || options.method != MotionMethod::Auto || linkage.thickness > 0 || run.over()) return outcome;
  FarMotion far = go_as_far(linkage, nullptr, {}, options, run);
  if (far.motion.path.waypoints.size() < 2) return outcome;
  outcome.notes.insert(outcome.notes.end(), far.notes.begin(), far.notes.end());
  outcome.ending = far.reached ? Ending::Found : Ending::Exhausted;
  outcome.progress = far.share;
  outcome.motions = {std::move(far.motion)};
  return outcome;
}

}  // namespace

MotionOutcome plan_origami(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  const Linkage linkage = make_linkage(sheet);
  if (!linkage.has_loops()) return fold_tree(linkage, options, run);
  check(options);
  return OrigamiPlanning(linkage, sheet, options, run).plan();
}

MotionOutcome reuse_motion(const Linkage& small, const FoldingPath& path, const Linkage& large,
                           const MotionOptions& options, const Run& run) {
  require_closable(large);
  return OrigamiPlanning(large, {}, options, run).carry(small, path);
}

}  // namespace plico
