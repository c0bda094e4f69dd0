#include "plico/io/motion/csv.h"

#include "plico/base/error.h"

namespace plico {

std::string write_trajectory_csv(const FoldingPath& path) {
  PLICO_ASSERT(!path.waypoints.empty());
  std::string csv = "time";
  for (int h = 0; h < path.waypoints.front().config.size(); ++h) csv += fmt::format(",hinge_{}_deg", h);
  csv += '\n';
  for (const Waypoint& waypoint : path.waypoints) {
    csv += fmt::format("{}", waypoint.time);
    for (double angle : waypoint.config) csv += fmt::format(",{}", degrees(angle) + 0.0);
    csv += '\n';
  }
  return csv;
}

}  // namespace plico
