#include "plico/inflate/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

// The angle sum is pressed this far below 2 pi, so that rounding does not bring a vertex back; radians.
constexpr double kMargin = 0.02;
// Excess below this is about to go, above it is likely a feature that stays; radians.
constexpr double kSoft = 0.1;
// Half a room beyond the room, the wall pushes 5 times as much as air and flattening at 5 % of volume.
constexpr double kWall = 200;

// Of a corner inside its triangle, and how it changes with the two other corners.
struct CornerAngle {
  double angle = 0;
  Vec3 by_next, by_previous;
};

CornerAngle corner_angle(const Vec3& u, const Vec3& w) {
  const Vec3 cross = u.cross(w);
  const double twice_area = cross.norm();
  if (!(twice_area > 0)) return {plico::atan2(0.0, u.dot(w)), Vec3::Zero(), Vec3::Zero()};
  const Vec3 normal = cross / twice_area;
  return {plico::atan2(twice_area, u.dot(w)), -normal.cross(u) / u.squaredNorm(), normal.cross(w) / w.squaredNorm()};
}

}  // namespace

void check(const SkinOptions& options) {
  require(options.edge_stiffness > 0, "edge-stiffness", options.edge_stiffness, "above 0");
  require(options.stiff_edges >= 1, "stiff-edges", options.stiff_edges, "at least 1");
  require(options.deep_angle >= 0, "deep-angle", options.deep_angle, "at least 0");
  require(options.anchor_stiffness >= 0, "anchor-stiffness", options.anchor_stiffness, "at least 0");
  require(options.stiff_anchors >= 1, "stiff-anchors", options.stiff_anchors, "at least 1");
  require(options.flattening >= 0, "flattening", options.flattening, "at least 0");
}

SkinEnergy::SkinEnergy(const Mesh& mesh, const SkinOptions& options, const std::vector<FaceId>& kept)
    : options_(options),
      unit_(mean_edge_length(mesh)),
      center_(bounding_box(mesh).center()),
      origin_(3 * mesh.num_vertices()),
      points_(mesh.soup().points),
      triangles_(mesh.soup().corners),
      fixed_(mesh.num_vertices(), 0) {
  for (VertexId v : mesh.vertices()) origin_.segment<3>(3 * v) = (mesh.point(v) - center_) / unit_;
  for (EdgeId e : mesh.edges()) {
    ends_.push_back(mesh.from(mesh.halfedge(e)));
    ends_.push_back(mesh.to(mesh.halfedge(e)));
    rest_.push_back(length(mesh, e) / unit_);
  }
  for (FaceId f : kept)
    for (int v : mesh.corners(f)) fixed_[v] = 1;
  volume_ = volume(origin_);
  classify(mesh, hyperbolic_vertices(mesh));
}

std::vector<char> hyperbolic_vertices(const Mesh& mesh) {
  std::vector<char> is(mesh.num_vertices());
  for (VertexId v : mesh.vertices()) is[v] = is_hyperbolic(mesh, v);
  return is;
}

int count_hyperbolic(const std::vector<char>& hyperbolic) {
  return static_cast<int>(std::count(hyperbolic.begin(), hyperbolic.end(), 1));
}

void SkinEnergy::classify(const Mesh& now, const std::vector<char>& hyperbolic) {
  edge_stiffness_.assign(now.num_edges(), options_.edge_stiffness);
  anchor_stiffness_.assign(now.num_vertices(), 0);
  flatten_.assign(now.num_vertices(), 0);
  // The steepest descent of sum log(excess + kSoft): few vertices keep much rather than many a little. Negative
  // curvature cannot vanish where limbs meet a body, but it can gather.
  for (VertexId v : options_.flattening > 0 ? now.vertices() : IdRange<VertexId>(0)) {
    const double excess = std::max(angle_sum(now, v) - 2 * kPi, 0.0) + kSoft;
    flatten_[v] = 1 / (excess * excess);
  }
  if (!options_.constrained) return;
  for (EdgeId e : now.edges()) {
    const double angle = fold_angle(now, e);
    if (angle < 0 || angle > options_.deep_angle) edge_stiffness_[e] *= options_.stiff_edges;
  }
  for (VertexId v : now.vertices())
    anchor_stiffness_[v] = options_.anchor_stiffness * (hyperbolic[v] ? 1 : options_.stiff_anchors);
}

double SkinEnergy::springs(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  double sum = 0;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const int a = ends_[2 * e], b = ends_[2 * e + 1];
    const Vec3 side = x.segment<3>(3 * b) - x.segment<3>(3 * a);
    const double length = side.norm(), stretch = length - rest_[e];
    if (stretch <= 0) continue;
    sum += edge_stiffness_[e] * stretch * stretch / 2;
    const Vec3 pull = edge_stiffness_[e] * stretch / length * side;
    gradient.segment<3>(3 * b) += pull;
    gradient.segment<3>(3 * a) -= pull;
  }
  return sum;
}

double SkinEnergy::anchors(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  double sum = 0;
  for (std::size_t v = 0; v < fixed_.size(); ++v) {
    const Vec3 move = x.segment<3>(3 * v) - origin_.segment<3>(3 * v);
    sum += anchor_stiffness_[v] * move.squaredNorm() / 2;
    gradient.segment<3>(3 * v) += anchor_stiffness_[v] * move;
  }
  return sum;
}

double SkinEnergy::volume(const Eigen::VectorXd& x) const {
  double sum = 0;
  for (int f = 0; f < static_cast<int>(triangles_.size()) / 3; ++f)
    sum += corner(x, f, 0).dot(corner(x, f, 1).cross(corner(x, f, 2)));
  return sum / 6;
}

double SkinEnergy::air(const Eigen::VectorXd& x, double pressure, Eigen::VectorXd& gradient) const {
  const double now = volume(x);
  if (!(now > 0)) return std::numeric_limits<double>::infinity();
  const double change = now / volume_ - 1;
  const double beyond = std::max(0.0, std::abs(change) - room_);
  const double wall = pressure * kWall * std::max(1.0, options_.flattening);
  const double push = (pressure * volume_ / now - std::copysign(2 * wall * beyond, change)) / 6;
  for (int f = 0; f < static_cast<int>(triangles_.size()) / 3; ++f)
    for (int i = 0; i < 3; ++i)
      gradient.segment<3>(3 * triangles_[3 * f + i]) -=
          push * corner(x, f, (i + 1) % 3).cross(corner(x, f, (i + 2) % 3));
  return volume_ * (wall * beyond * beyond - pressure * plico::log(now / volume_));
}

double SkinEnergy::excess(const Eigen::VectorXd& x, double weight, Eigen::VectorXd& gradient) const {
  std::vector<double> above(fixed_.size(), -2 * kPi);
  std::vector<CornerAngle> angles(triangles_.size());
  for (std::size_t c = 0; c < triangles_.size(); ++c) {
    const int f = static_cast<int>(c / 3), i = static_cast<int>(c % 3);
    const Vec3 tip = corner(x, f, i);
    angles[c] = corner_angle(corner(x, f, (i + 1) % 3) - tip, corner(x, f, (i + 2) % 3) - tip);
    above[triangles_[c]] += angles[c].angle;
  }
  double sum = 0;
  for (std::size_t v = 0; v < above.size(); ++v) {
    const double over = std::max(above[v] + kMargin, 0.0);
    sum += flatten_[v] * over * over;
    above[v] = flatten_[v] * over;
  }
  for (std::size_t c = 0; c < triangles_.size(); ++c) {
    const std::size_t first = c - c % 3;
    const double factor = 2 * weight * above[triangles_[c]];
    if (factor == 0) continue;
    gradient.segment<3>(3 * triangles_[first + (c + 1) % 3]) += factor * angles[c].by_next;
    gradient.segment<3>(3 * triangles_[first + (c + 2) % 3]) += factor * angles[c].by_previous;
    gradient.segment<3>(3 * triangles_[c]) -= factor * (angles[c].by_next + angles[c].by_previous);
  }
  return weight * sum;
}

double SkinEnergy::operator()(double pressure, const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  gradient.setZero();
  double sum = springs(x, gradient) + anchors(x, gradient) + air(x, pressure, gradient);
  if (options_.flattening > 0) sum += excess(x, pressure * options_.flattening, gradient);
  gradient = only_free(std::move(gradient));
  return sum;
}

Eigen::VectorXd SkinEnergy::only_free(Eigen::VectorXd forces) const {
  for (std::size_t v = 0; v < fixed_.size(); ++v)
    if (fixed_[v]) forces.segment<3>(3 * v).setZero();
  return forces;
}

std::vector<Vec3> SkinEnergy::points(const Eigen::VectorXd& x) const {
  std::vector<Vec3> result;
  for (std::size_t v = 0; v < fixed_.size(); ++v) {
    const Vec3 now = x.segment<3>(3 * v);
    result.push_back(now == origin_.segment<3>(3 * v) ? points_[v] : Vec3(center_ + unit_ * now));
  }
  return result;
}

}  // namespace plico
