#include "plico/motion/planner.h"

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/motion/collision.h"

namespace plico {
namespace {
constexpr long kMostPanels = 10'000'000;
}

std::string_view name(Planner planner) {
  switch (planner) {
    case Planner::LazyPrm:
      return "lazy-prm";
    case Planner::Prm:
      return "prm";
    case Planner::RrtConnect:
      return "rrt-connect";
  }
  return "unknown";
}

void check(const PlannerOptions& options) {
  require(options.resolution > 0 && options.resolution <= 1, "resolution", options.resolution, "in (0, 1]");
  require(options.max_states >= 0, "max states", options.max_states, "at least 0");
}

long most_states(const Linkage& linkage) {
  return kMostPanels / std::max<long>(1, static_cast<long>(linkage.panels.size()));
}

bool blends_freely(const Linkage& linkage, const FoldingPath& a, const FoldingPath& b, double clearance) {
  CollisionChecker checker(linkage, {.clearance = clearance});
  constexpr int kSteps = 50;
  for (double share : {0.5, 0.25, 0.75}) {
    for (int i = 1; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      if (checker.collides((1 - share) * a.at(t) + share * b.at(t))) return false;
    }
  }
  return true;
}

ValidRatio valid_ratio(const Linkage& linkage, int samples, std::uint64_t seed, double clearance) {
  require(samples >= 1, "samples", samples, "at least 1");
  CollisionChecker checker(linkage, {.clearance = clearance});
  const Rng rng(seed);
  const Configuration target = goal(linkage);
  int discrete = 0, uniform = 0;
  for (int i = 0; i < samples; ++i) {
    Rng own = rng.stream(i);
    Configuration picked = target, mixed = target;
    for (double& angle : picked) angle *= own.below(2);
    for (double& angle : mixed) angle *= own.uniform();
    discrete += !checker.collides(picked);
    uniform += !checker.collides(mixed);
  }
  return {static_cast<double>(discrete) / samples, static_cast<double>(uniform) / samples};
}

}  // namespace plico
