#include "plico/mesh/upright.h"

#include <cmath>
#include <utility>
#include <vector>

#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kSymmetric = 0.2;  // odd moments of what has equal halves, about
constexpr double kLopsided = 0.05;  // at least those of what has not; less is rounding
constexpr double kClearly = 0.5;    // of the other axis' odd moments
constexpr double kLowest = 0.03;    // of the height: what a shape stands on

// How unequal the halves on both sides of the middle across each axis are: the moments of the surface that vanish when
// they are mirror images, however the surface is cut into faces.
Vec3 odd_moments(const Mesh& mesh) {
  std::vector<std::pair<double, Vec3>> points;  // with weights: midpoints of sides integrate what is quadratic
  Vec3 middle = Vec3::Zero();
  double total = 0;
  for (FaceId f : mesh.faces()) {
    const double weight = area(mesh, f) / mesh.degree(f);
    for (HalfedgeId h : mesh.halfedges(f)) {
      points.emplace_back(weight, (mesh.point(mesh.from(h)) + mesh.point(mesh.to(h))) / 2);
      middle += weight * points.back().second;
      total += weight;
    }
  }
  if (!(total > 0)) return Vec3::Ones();
  middle /= total;
  Vec3 spread = Vec3::Zero();
  for (const auto& [weight, p] : points) spread += weight / total * (p - middle).cwiseAbs2();
  spread = spread.cwiseSqrt().cwiseMax(1e-12);
  Eigen::Matrix3d third = Eigen::Matrix3d::Zero(), second = third;  // of x_i x_j^2 and x_i x_j
  for (const auto& [weight, at] : points) {
    const Vec3 p = (at - middle).cwiseQuotient(spread);
    third += weight / total * p * p.cwiseAbs2().transpose();
    second += weight / total * p * p.transpose();
  }
  Vec3 odd;
  for (int i = 0; i < 3; ++i)
    odd[i] = third.row(i).cwiseAbs().sum() + second.row(i).cwiseAbs().sum() - std::abs(second(i, i));
  return odd;
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

// Several pieces begin at one height and end at different ones, as things do that stand on a table.
bool share_only_the_floor(const Mesh& mesh, const Components& pieces, int up) {
  std::vector<Eigen::AlignedBox1d> range(pieces.count);
  for (FaceId f : mesh.faces())
    for (HalfedgeId h : mesh.halfedges(f))
      range[pieces.of_face[f]].extend(Eigen::Matrix<double, 1, 1>(mesh.point(mesh.from(h))[up]));
  Eigen::AlignedBox1d floor, top;
  for (const Eigen::AlignedBox1d& r : range) {
    floor.extend(r.min());
    top.extend(r.max());
  }
  const double least = kLowest * (top.max()[0] - floor.min()[0]);
  return floor.sizes()[0] <= least && top.sizes()[0] > least;
}

}  // namespace

char guessed_up(const Mesh& mesh) {
  if (const Components pieces = components(mesh); pieces.count > 1) {
    const bool along_y = share_only_the_floor(mesh, pieces, 1), along_z = share_only_the_floor(mesh, pieces, 2);
    if (along_y != along_z) return along_z ? 'z' : 'y';
  }
  const Vec3 odd = odd_moments(mesh);
  const auto only_first_is_even = [](double a, double b) {
    return a < kSymmetric && b > kLopsided && a < kClearly * b;
  };
  if (only_first_is_even(odd.y(), odd.z())) return 'z';
  if (only_first_is_even(odd.z(), odd.y())) return 'y';
  return steadiness(mesh, 2) > 1.2 * steadiness(mesh, 1) ? 'z' : 'y';
}

Eigen::Matrix3d z_up_from(char up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (up == 'y') turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return turn;
}

}  // namespace plico
