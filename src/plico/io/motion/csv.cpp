#include "plico/io/motion/csv.h"

#include "plico/base/error.h"

namespace plico {

std::string write_trajectory_csv(const FoldingPath& path, std::span<const Hinge> hinges) {
  PLICO_ASSERT(!path.waypoints.empty());
  std::string csv = "time";
  for (int h = 0; h < path.waypoints.front().config.size(); ++h) {
    const bool named = h < static_cast<int>(hinges.size()) && hinges[h].a >= 0 && hinges[h].b >= 0;
    csv += named ? fmt::format(",crease_{}_{}_deg", hinges[h].a, hinges[h].b) : fmt::format(",hinge_{}_deg", h);
  }
  csv += '\n';
  for (const Waypoint& waypoint : path.waypoints) {
    csv += fmt::format("{}", waypoint.time);
    for (double angle : waypoint.config) csv += fmt::format(",{}", degrees(angle) + 0.0);
    csv += '\n';
  }
  return csv;
}

}  // namespace plico
