#include "plico/verify/proof_plates.h"

#include <algorithm>
#include <cmath>

#include "plico/geom/polygon.h"

namespace plico {
namespace {

// Where the lines a0-a1 and a1-a2, both moved left by `distance`, meet; at sharp tips no farther than 4 distances from
// a1.
Vec2 meet_moved(const Vec2& a0, const Vec2& a1, const Vec2& a2, double distance) {
  const Vec2 u = (a1 - a0).normalized(), v = (a2 - a1).normalized();
  const double sine = cross(u, v);
  if (std::abs(sine) < 1e-9) return a1 + distance * perpendicular(u);  // straight on
  const Vec2 moved = (distance / sine) * (v - u);
  return a1 + moved * std::min(1.0, 4 * distance / moved.norm());
}

std::vector<Vec2> shrunk(const std::vector<Vec2>& outline, double clearance) {
  const std::size_t n = outline.size();
  const auto at = [&](std::size_t i) -> const Vec2& { return outline[i % n]; };
  for (int halvings = 0; halvings < 30; ++halvings, clearance /= 2) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(meet_moved(at(i + n - 1), at(i), at(i + 1), clearance));
    bool sound = true;
    for (std::size_t i = 0; i < n && sound; ++i) {
      const Vec2 side = at(i + 1) - at(i);
      sound = side.dot(result[(i + 1) % n] - result[i]) >= 0.5 * side.squaredNorm();
    }
    if (sound) return result;
  }
  return outline;
}

double farthest_across(const std::vector<Vec3>& outline, const Hinge& hinge, double sign) {
  const Vec3 along = (hinge.to - hinge.from).normalized();
  double farthest = 0;
  for (const Vec3& corner : outline) farthest = std::max(farthest, -sign * along.cross(corner - hinge.from).z());
  return farthest;
}

}  // namespace

bool ProofPlates::may_collide(int plate_a, int plate_b) const {
  const int a = panel[plate_a], b = panel[plate_b];
  if (a == b || part[plate_a] != part[plate_b]) return false;
  return std::find(hinged[a].begin(), hinged[a].end(), b) == hinged[a].end();
}

ProofPlates proof_plates(const Linkage& linkage, double clearance) {
  ProofPlates plates;
  plates.num_panels = linkage.num_panels();
  plates.are_thick = linkage.thickness > 0;
  const double half = linkage.thickness / 2;
  plates.hinged.resize(linkage.panels.size());
  const std::vector<int> part_of_panel = parts(linkage);
  for (int p = 0; p < linkage.num_panels(); ++p) {
    std::vector<Vec2> outline;
    for (const Vec3& corner : linkage.panels[p]) outline.emplace_back(corner.x(), corner.y());
    outline = shrunk(outline, clearance);
    const auto add = [&](const std::vector<Vec2>& plate) {
      std::vector<Vec3>& corners = plates.corners.emplace_back();
      for (const Vec2& corner : plate) corners.emplace_back(corner.x(), corner.y(), -half);
      if (plates.are_thick)
        for (const Vec2& corner : plate) corners.emplace_back(corner.x(), corner.y(), half);
      plates.panel.push_back(p);
      plates.part.push_back(part_of_panel[p]);
    };
    if (is_convex(outline))
      add(outline);
    else
      for (const auto& t : triangulate(outline)) add({outline[t[0]], outline[t[1]], outline[t[2]]});
  }
  if (plates.are_thick) return plates;
  for (const Hinge& hinge : linkage.hinges) {
    const double slack = 1e-9 * (hinge.to - hinge.from).norm();
    if (farthest_across(linkage.panels[hinge.left], hinge, 1) > slack) continue;
    if (farthest_across(linkage.panels[hinge.right], hinge, -1) > slack) continue;
    plates.hinged[hinge.left].push_back(hinge.right);
    plates.hinged[hinge.right].push_back(hinge.left);
  }
  return plates;
}

}  // namespace plico
