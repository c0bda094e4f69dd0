#include "plico/workflow/plan_motion.h"

#include <algorithm>
#include <array>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/motion/collision.h"
#include "plico/origami/closure.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr std::array<std::string_view, 10> kMethods = {"auto", "linear",       "uniform", "lazy-prm", "rrt-connect",
                                                       "prm",  "continuation", "frog",    "md-frog",  "reuse"};
constexpr int kPlanners = 9;  // of them
constexpr int kTriesPerAlternative = 20;
constexpr int kMostUniform = 5000;  // hinges: nearly each stops at its own moment, and 5,000 of each are 200 MB

Planner planner_of(MotionMethod method) {
  return method == MotionMethod::RrtConnect ? Planner::RrtConnect
         : method == MotionMethod::Prm      ? Planner::Prm
                                            : Planner::LazyPrm;
}

class Planning {
 public:
  Planning(const Linkage& linkage, const MotionOptions& options, const Run& run)
      : linkage_(linkage), options_(options), run_(run) {}

  MotionOutcome plan() {
    const bool any = options_.method == MotionMethod::Auto;
    if (any || options_.method == MotionMethod::Linear) take(MotionMethod::Linear, linear_path(linkage_), run_);
    if (!enough() && (any ? may_be_uniform() : options_.method == MotionMethod::Uniform))
      take(MotionMethod::Uniform, uniform_path(linkage_), run_);
    if (!enough() && (any ? options_.may_search && has_planners() : wants_a_planner())) search();
    if (outcome_.motions.empty()) take(MotionMethod::Linear, linear_path(linkage_), {});
    if (enough())
      outcome_.ending = Ending::Found;
    else
      outcome_.ending = run_.over() ? run_.ending() : Ending::Exhausted;
    return std::move(outcome_);
  }

 private:
  bool enough() const { return free_ >= options_.alternatives; }
  bool may_be_uniform() const { return linkage_.num_hinges() <= kMostUniform && !run_.over(); }
  bool wants_a_planner() const {
    return options_.method != MotionMethod::Linear && options_.method != MotionMethod::Uniform;
  }

  long states_to_check() const {
    const long most = options_.alternatives * most_states(linkage_);
    return std::max(1L, static_cast<long>(options_.effort * static_cast<double>(most)));
  }

  // Planned paths are free at their samples only; one that the proof refutes costs another try.
  void search() {
    const MotionMethod method = options_.method == MotionMethod::Auto ? MotionMethod::LazyPrm : options_.method;
    const Rng rng(options_.seed);
    long states = states_to_check();  // left, in all tries
    for (int i = 0; i < kTriesPerAlternative * options_.alternatives && states > 0 && !enough() && !run_.over(); ++i) {
      const PlannerOptions planner{.seed = rng.stream(i).next(),
                                   .planner = planner_of(method),
                                   .clearance = options_.clearance,
                                   .resolution = 0.005 / (1 + i),
                                   .max_states = states};
      const PlannedPath planned = plan_path(linkage_, planner, run_);
      states -= std::max(1L, planned.states_checked);
      if (planned.ending != Ending::Found) return;
      take(method, planned.path, run_);
      run_.report("planning a motion", i + 1, 0, fmt::format("{} proven", free_));
    }
  }

  void take(MotionMethod method, FoldingPath path, const Run& run) {
    for (const Motion& other : outcome_.motions)
      if (other.proof.verdict == PathVerdict::Free && blends_freely(linkage_, other.path, path, options_.clearance))
        return;
    Motion motion{method, std::move(path), {}};
    motion.proof = prove_path(linkage_, motion.path, {.clearance = options_.clearance}, run);
    const bool free = motion.proof.verdict == PathVerdict::Free;
    if (free && free_++ == 0) outcome_.motions.clear();  // the first that folds replaces the best that does not
    if (free || outcome_.motions.empty()) {
      outcome_.motions.push_back(std::move(motion));
    } else if (free_ == 0 && motion.proof.from > outcome_.motions.front().proof.from) {
      outcome_.motions.front() = std::move(motion);
    }
  }

  const Linkage& linkage_;
  const MotionOptions& options_;
  const Run& run_;
  MotionOutcome outcome_;
  int free_ = 0;
};

// Motions of trees stay between flat and the goal, so only the goal can exceed a limit.
MotionOutcome plan_tree(const Linkage& linkage, const MotionOptions& options, const Run& run) {
  if (!contract(options.method).trees)
    throw InvalidOption(fmt::format("{} is for crease patterns with loops; this sheet has none", name(options.method)));
  if (options.grouped || !options.through.empty())
    throw InvalidOption("crease groups and states to pass are for crease patterns with loops; this sheet has none");
  require_within_limits(linkage, goal(linkage), "the goal");
  return Planning(linkage, options, run).plan();
}

}  // namespace

std::vector<std::string> motion_methods() { return {kMethods.begin(), kMethods.begin() + kPlanners}; }

MotionMethod motion_method(std::string_view name) {
  const auto end = kMethods.begin() + kPlanners, at = std::find(kMethods.begin(), end, name);
  if (at == end) throw InvalidOption(fmt::format("there is no planner '{}'", name));
  return static_cast<MotionMethod>(at - kMethods.begin());
}

std::vector<std::string> facet_policies() { return {"auto", "none", "all"}; }

FacetPolicy facet_policy(std::string_view name) {
  const std::vector<std::string> names = facet_policies();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw InvalidOption(fmt::format("there is no way '{}' to cut facets", name));
  return static_cast<FacetPolicy>(at - names.begin());
}

PlannerContract contract(MotionMethod method) {
  switch (method) {
    case MotionMethod::Auto:
      return {.trees = true, .loops = true, .thickness = true, .goes_to_limits = true};
    case MotionMethod::Linear:
    case MotionMethod::Uniform:
    case MotionMethod::LazyPrm:
    case MotionMethod::RrtConnect:
    case MotionMethod::Prm:
      return {.trees = true, .thickness = true};
    case MotionMethod::Continuation:
    case MotionMethod::Reuse:
      return {.loops = true, .goes_to_limits = true};
    case MotionMethod::Frog:
    case MotionMethod::MdFrog:
      return {.loops = true};
  }
  PLICO_ASSERT(false);
  return {};
}

std::string_view name(MotionMethod method) { return kMethods[static_cast<std::size_t>(method)]; }

MotionOutcome plan(const Linkage& linkage, const MotionOptions& options, const Run& run) {
  require(options.alternatives >= 1, "alternatives", options.alternatives, "at least 1");
  require(options.effort > 0 && options.effort <= 1, "effort", options.effort, "in (0, 1]");
  require_closable(linkage);
  return linkage.has_loops() ? plan_loops(linkage, options, run) : plan_tree(linkage, options, run);
}

NoiseVerdict fold_with_noise(const Linkage& linkage, const FoldingPath& path, double noise, int samples,
                             std::uint64_t seed, double clearance, const Run& run) {
  require(noise >= 0, "angle noise", noise, "at least 0");
  require(samples >= 1, "samples", samples, "at least 1");
  constexpr int kSteps = 100;
  const Configuration low = lower_limits(linkage), high = upper_limits(linkage);
  const Rng rng(seed);
  std::vector<double> stop(samples, -1);
  parallel_for(run, samples, [&](int i) {
    Rng own = rng.stream(i);
    CollisionChecker checker(linkage, {.clearance = clearance});
    Configuration off(linkage.num_hinges());
    for (double& angle : off) angle = own.uniform(-noise, noise);
    double first = 1;
    bool folded = true;
    for (int k = 1; k <= kSteps && folded; ++k) {
      if (run.over()) return;
      const double t = static_cast<double>(k) / kSteps;
      const Configuration config = (path.at(t) + t * off).cwiseMax(low).cwiseMin(high);
      folded = !checker.collides(config);
      first = t;
    }
    stop[i] = folded ? 2 : first;
  });
  NoiseVerdict verdict;
  double sum = 0;
  for (double s : stop) {
    if (s < 0) continue;  // not reached before the run was over
    ++verdict.samples;
    verdict.folded += s > 1;
    sum += std::min(s, 1.0);
  }
  if (verdict.samples > 0) verdict.mean_stop = sum / verdict.samples;
  return verdict;
}

}  // namespace plico
