#include "plico/origami/layers.h"

#include <algorithm>
#include <cmath>

#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

constexpr double kFlat = 1e-7;  // of the mean side length; also of a normal, as its sine

}  // namespace

Layers::Layers(const Linkage& linkage, double clearance)
    : linkage_(linkage),
      plates_(make_plates(linkage, clearance)),
      neighbours_(linkage.panels.size()),
      flat_(kFlat * mean_side_length(linkage)) {
  for (const Hinge& hinge : linkage.hinges) {
    neighbours_[hinge.left].push_back(hinge.right);
    neighbours_[hinge.right].push_back(hinge.left);
  }
}

std::vector<LayerPair> Layers::stacked(const Configuration& config) const {
  const std::vector<Pose> poses = folding_map(linkage_, config);
  std::vector<LayerPair> pairs;
  std::vector<Vec2> below, above;
  for (int a = 0; a < plates_.size(); ++a)
    for (int b = a + 1; b < plates_.size(); ++b) {
      const int panel_a = plates_.panel[a], panel_b = plates_.panel[b];
      const auto& beside = neighbours_[panel_a];
      if (panel_a == panel_b || std::find(beside.begin(), beside.end(), panel_b) != beside.end()) continue;
      const Pose seen = poses[panel_a].inverse(Eigen::Isometry) * poses[panel_b];  // b from a
      if (seen.linear().col(2).head<2>().norm() > kFlat) continue;
      below.clear();
      above.clear();
      double off = 0;
      for (int i = plates_.first[a]; i < plates_.first[a + 1]; ++i) below.push_back(plates_.corners[i].head<2>());
      for (int i = plates_.first[b]; i < plates_.first[b + 1]; ++i) {
        const Vec3 corner = seen * plates_.corners[i];
        above.push_back(corner.head<2>());
        off = std::max(off, std::abs(corner.z()));
      }
      if (off > flat_) continue;
      const std::vector<Vec2> both = clipped(above, below);
      if (std::abs(signed_area(both)) < flat_ * flat_) continue;
      const Vec2 middle = centroid(both);
      pairs.push_back({a, b, seen.inverse(Eigen::Isometry) * Vec3(middle.x(), middle.y(), 0)});
    }
  return pairs;
}

std::vector<signed char> Layers::sides(const std::vector<LayerPair>& pairs, const Configuration& config) const {
  const std::vector<Pose> poses = folding_map(linkage_, config);
  std::vector<signed char> sides;
  for (const LayerPair& pair : pairs) {
    const Pose& a = poses[plates_.panel[pair.a]];
    const double height = (a.inverse(Eigen::Isometry) * (poses[plates_.panel[pair.b]] * pair.point)).z();
    sides.push_back(static_cast<signed char>(std::abs(height) <= flat_ ? 0 : height > 0 ? 1 : -1));
  }
  return sides;
}

}  // namespace plico
