#include "plico/fold/folding_order.h"

#include <cmath>

namespace plico {

std::vector<FoldStep> folding_order(const FoldingPath& path, double still) {
  std::vector<FoldStep> steps;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Waypoint &a = path.waypoints[i - 1], &b = path.waypoints[i];
    FoldStep step{a.time, b.time, {}, {}};
    for (int h = 0; h < b.config.size(); ++h) {
      if (std::abs(b.config[h] - a.config[h]) <= still) continue;
      step.hinges.push_back(h);
      step.angles.push_back(b.config[h]);
    }
    if (step.hinges.empty()) continue;
    if (!steps.empty() && steps.back().hinges == step.hinges) {
      steps.back().to = step.to;
      steps.back().angles = std::move(step.angles);
    } else {
      steps.push_back(std::move(step));
    }
  }
  return steps;
}

}  // namespace plico
