#include "plico/origami/orders.h"

#include <algorithm>
#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

constexpr double kFromFlat = 0.15;   // of the draws
constexpr double kSpread = 2.7;      // of the factors, one standard deviation up
constexpr double kMostUndone = 0.7;  // of the waypoints, that a draw goes back by

// The way up to a drawn moment, the later the likelier.
FoldingPath drawn_part(const FoldingPath& path, Rng& rng) {
  const double from = rng.uniform(), undone = kMostUndone * rng.uniform() * rng.uniform();
  if (from < kFromFlat || path.waypoints.size() < 3) return {};
  FoldingPath part = path;
  const double kept = (1 - undone) * static_cast<double>(path.waypoints.size());
  part.waypoints.resize(std::max<std::size_t>(2, static_cast<std::size_t>(kept)));
  return part;
}

}  // namespace

ContinuationResult approach_in_drawn_order(const Linkage& linkage, const FoldingPath& begun,
                                           const ApproachOptions& options, Rng rng, const Run& run) {
  ApproachOptions drawn = options;
  drawn.emphasis.resize(linkage.num_hinges());
  for (double& factor : drawn.emphasis) factor = plico::pow(kSpread, rng.normal());
  const ContinuationResult first = approach_goal(linkage, drawn_part(begun, rng), drawn, run);
  if (first.path.waypoints.size() < 2) return first;
  return approach_goal(linkage, first.path, options, run);
}

}  // namespace plico
