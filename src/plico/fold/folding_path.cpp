#include "plico/fold/folding_path.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {

Configuration FoldingPath::at(double time) const {
  PLICO_ASSERT(waypoints.size() >= 2);
  const auto after = std::upper_bound(waypoints.begin(), waypoints.end(), time,
                                      [](double t, const Waypoint& w) { return t < w.time; });
  if (after == waypoints.begin()) return waypoints.front().config;
  if (after == waypoints.end()) return waypoints.back().config;
  const Waypoint &a = *(after - 1), &b = *after;
  const double s = (time - a.time) / (b.time - a.time);
  return (1 - s) * a.config + s * b.config;
}

int waypoint_beyond_limits(const Linkage& linkage, const FoldingPath& path) {
  const auto beyond = [&](const Waypoint& w) { return hinge_beyond_limits(linkage, w.config, kLimitRounding) >= 0; };
  const auto first = std::find_if(path.waypoints.begin(), path.waypoints.end(), beyond);
  return first == path.waypoints.end() ? -1 : static_cast<int>(first - path.waypoints.begin());
}

void require_within_limits(const Linkage& linkage, const FoldingPath& path) {
  const int at = waypoint_beyond_limits(linkage, path);
  if (at < 0) return;
  const Waypoint& waypoint = path.waypoints[at];
  require_within_limits(linkage, waypoint.config, fmt::format("at t = {:.4g} the motion", waypoint.time),
                        kLimitRounding);
}

FoldingPath linear_path(const Linkage& linkage) { return {{{0, flat(linkage)}, {1, goal(linkage)}}}; }

FoldingPath uniform_path(const Linkage& linkage) {
  const Configuration target = goal(linkage);
  std::vector<double> stops{0};
  for (double angle : target) stops.push_back(std::abs(angle));
  std::sort(stops.begin(), stops.end());
  // Creases whose angles differ by rounding only stop together.
  stops.erase(std::unique(stops.begin(), stops.end(), [](double a, double b) { return b - a < 1e-12; }), stops.end());
  const double last = stops.back();
  if (last == 0) return linear_path(linkage);
  FoldingPath path;
  for (double stop : stops) {
    Configuration config = target.cwiseMax(-stop).cwiseMin(stop);
    path.waypoints.push_back({stop / last, std::move(config)});
  }
  path.waypoints.back().config = target;
  return path;
}

}  // namespace plico
