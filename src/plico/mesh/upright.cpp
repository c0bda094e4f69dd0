#include "plico/mesh/upright.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr int kMostLookedAt = 300;  // vertices whose mirror images are looked for
constexpr double kNear = 0.01;      // of the diagonal: a mirror image is there
constexpr double kMostMatch = 0.9;  // of the vertices, of what is symmetric
constexpr double kLowest = 0.03;    // of the height: what a shape stands on

// The share of the vertices that have a partner on the other side of the middle plane across `axis`.
double symmetry(const Mesh& mesh, int axis) {
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  const double near = kNear * box.diagonal().norm();
  const int n = mesh.num_vertices(), step = std::max(1, n / kMostLookedAt);
  int looked = 0, matched = 0;
  for (int v = 0; v < n; v += step, ++looked) {
    Vec3 image = mesh.point(VertexId(v));
    image[axis] = 2 * box.center()[axis] - image[axis];
    for (int other = 0; other < n; ++other) {
      if ((mesh.point(VertexId(other)) - image).squaredNorm() > near * near) continue;
      ++matched;
      break;
    }
  }
  return looked ? static_cast<double>(matched) / looked : 0;
}

// The area below the lowest points over that of the box, 0 when the middle of the vertices is not above it.
double steadiness(const Mesh& mesh, int up) {
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  const int x = (up + 1) % 3, y = (up + 2) % 3;
  std::vector<Vec2> feet;
  Vec2 middle = Vec2::Zero();
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const Vec3& p = mesh.point(VertexId(v));
    middle += Vec2(p[x], p[y]) / mesh.num_vertices();
    if (p[up] <= box.min()[up] + kLowest * box.sizes()[up]) feet.emplace_back(p[x], p[y]);
  }
  const std::vector<Vec2> base = convex_hull(std::move(feet));
  for (std::size_t i = 0; i < base.size(); ++i)
    if (cross(base[(i + 1) % base.size()] - base[i], middle - base[i]) < 0) return 0;
  const double floor = box.sizes()[x] * box.sizes()[y];
  return base.size() > 2 && floor > 0 ? signed_area(base) / floor : 0;
}

}  // namespace

char guessed_up(const Mesh& mesh) {
  const bool across_y = symmetry(mesh, 1) >= kMostMatch, across_z = symmetry(mesh, 2) >= kMostMatch;
  if (across_y != across_z) return across_y ? 'z' : 'y';
  return steadiness(mesh, 2) > 1.2 * steadiness(mesh, 1) ? 'z' : 'y';
}

Eigen::Matrix3d z_up_from(char up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (up == 'y') turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return turn;
}

}  // namespace plico
