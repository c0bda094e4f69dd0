#include "plico/verify/deformation.h"

#include <cmath>

namespace plico {
namespace {

constexpr double kUsualShare = 1e-3;  // of the mean side: the clearance of motions that close

// Of every vertex the mean of its places; not a number for one that no panel has.
std::vector<Vec3> mean_places(const CreasePattern& sheet, const std::vector<Pose>& poses) {
  std::vector<Vec3> sums(sheet.vertices.size(), Vec3::Zero());
  std::vector<int> counts(sheet.vertices.size(), 0);
  for (int f = 0; f < sheet.num_faces(); ++f)
    for (const int v : sheet.faces[f]) {
      sums[v] += poses[f] * Vec3(sheet.vertices[v].x(), sheet.vertices[v].y(), 0);
      ++counts[v];
    }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= counts[v];
  return sums;
}

}  // namespace

Deformation measure_deformation(const CreasePattern& sheet, const Linkage& linkage, const FoldingPath& path) {
  Deformation result;
  std::vector<Pose> poses;
  for (int w = 0; w < static_cast<int>(path.waypoints.size()); ++w) {
    folding_map(linkage, path.waypoints[w].config, poses);
    const std::vector<Vec3> places = mean_places(sheet, poses);
    for (int e = 0; e < sheet.num_edges(); ++e) {
      const Crease& edge = sheet.edges[e];
      const double length = (sheet.vertices[edge.b] - sheet.vertices[edge.a]).norm();
      const double change = std::abs((places[edge.b] - places[edge.a]).norm() / length - 1);
      if (!(change > result.worst)) continue;
      result.worst = change;
      result.waypoint = w;
      result.edge = e;
    }
  }
  return result;
}

double deformed_clearance(double clearance, double deformation) { return clearance * (1 + deformation / kUsualShare); }

}  // namespace plico
