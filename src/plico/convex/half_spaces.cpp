#include "plico/convex/half_spaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plico/base/rng.h"

namespace plico {
namespace {

constexpr double kSlack = 1e-12;     // of the radius
constexpr double kParallel = 1e-10;  // of a normal of length 1: what is left of it within another plane

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
struct HalfSpace {
  Vector<D> normal;
  double offset = 0;
};

// What is best: the nearest to the center, or the lowest of the ball around it.
template <int D>
struct Goal {
  Vector<D> uphill = Vector<D>::Zero();  // zero: the center itself is best
  Vector<D> center = Vector<D>::Zero();
  double radius = 0;

  Vector<D> best() const {
    const double slope = uphill.norm();
    return slope > 0 ? Vector<D>(center - radius / slope * uphill) : center;
  }
};

// An orthonormal basis of the directions within a plane.
Eigen::Matrix<double, 3, 2> basis_of(const Vector<3>& normal) {
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = normal.cross(Vector<3>::Unit(least)).normalized();
  axes.col(1) = normal.cross(Vector<3>(axes.col(0)));
  return axes;
}
Eigen::Matrix<double, 2, 1> basis_of(const Vector<2>& normal) { return {-normal.y(), normal.x()}; }

// The end of the interval, or the nearest point of it.
std::optional<Vector<1>> best_below(const std::vector<HalfSpace<1>>& planes, std::size_t count, const Goal<1>& goal,
                                    double slack) {
  double low = goal.center[0] - goal.radius, high = goal.center[0] + goal.radius;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = planes[i].offset / planes[i].normal[0];
    if (planes[i].normal[0] > 0) high = std::min(high, at);
    if (planes[i].normal[0] < 0) low = std::max(low, at);
  }
  if (low > high + slack) return std::nullopt;
  Vector<1> best;
  best[0] = std::clamp(goal.best()[0], std::min(low, high), std::max(low, high));
  return best;
}

template <int D>
std::optional<Vector<D>> best_below(const std::vector<HalfSpace<D>>& planes, std::size_t count, const Goal<D>& goal,
                                    double slack);

// The same on one plane: one unknown less.
template <int D>
std::optional<Vector<D>> best_on(const HalfSpace<D>& plane, const std::vector<HalfSpace<D>>& planes, std::size_t count,
                                 const Goal<D>& goal, double slack) {
  const double away = plane.normal.dot(goal.center) - plane.offset;
  if (std::abs(away) > goal.radius) return std::nullopt;
  const Vector<D> origin = goal.center - away * plane.normal;
  const auto axes = basis_of(plane.normal);
  std::vector<HalfSpace<D - 1>> inside;
  for (std::size_t i = 0; i < count; ++i) {
    Vector<D - 1> normal = axes.transpose() * planes[i].normal;
    const double offset = planes[i].offset - planes[i].normal.dot(origin), length = normal.norm();
    if (length > kParallel) {
      inside.push_back({normal / length, offset / length});
    } else if (offset < -slack) {
      return std::nullopt;
    }
  }
  const Goal<D - 1> within{axes.transpose() * goal.uphill, Vector<D - 1>::Zero(),
                           std::sqrt(std::max(0.0, goal.radius * goal.radius - away * away))};
  const auto best = best_below(inside, inside.size(), within, slack);
  if (!best) return std::nullopt;
  return Vector<D>(origin + axes * *best);
}

template <int D>
std::optional<Vector<D>> best_below(const std::vector<HalfSpace<D>>& planes, std::size_t count, const Goal<D>& goal,
                                    double slack) {
  Vector<D> best = goal.best();
  for (std::size_t i = 0; i < count; ++i) {
    if (planes[i].normal.dot(best) <= planes[i].offset + slack) continue;
    const auto next = best_on(planes[i], planes, i, goal, slack);
    if (!next) return std::nullopt;
    best = *next;
  }
  return best;
}

// About the center, in units of the radius.
std::optional<Vec3> solve(const HalfSpaceProblem& problem, const Vec3& uphill, const Vec3& center, double radius) {
  std::vector<HalfSpace<3>> planes;
  const auto scaled = [&](const Plane& plane) {
    return HalfSpace<3>{plane.normal, (plane.offset - plane.normal.dot(center)) / radius};
  };
  for (const Plane& plane : problem.below) planes.push_back(scaled(plane));
  Rng rng(planes.size());
  for (std::size_t i = planes.size(); i > 1; --i) std::swap(planes[i - 1], planes[rng.below(static_cast<int>(i))]);
  const Goal<3> goal{uphill, Vec3::Zero(), 1};
  std::optional<Vec3> best;
  if (problem.on.empty()) {
    best = best_below(planes, planes.size(), goal, kSlack);
  } else {
    // The other planes from both sides: the point lies on them.
    std::vector<HalfSpace<3>> all;
    for (const Plane& plane : problem.on.subspan(1)) {
      const HalfSpace<3> side = scaled(plane);
      all.insert(all.end(), {side, {-side.normal, -side.offset}});
    }
    all.insert(all.end(), planes.begin(), planes.end());
    best = best_on(scaled(problem.on[0]), all, all.size(), goal, kSlack);
  }
  if (!best) return std::nullopt;
  return Vec3(center + radius * *best);
}

}  // namespace

std::optional<Vec3> lowest_point(const HalfSpaceProblem& problem, const Vec3& uphill, const Vec3& center,
                                 double radius) {
  return solve(problem, uphill, center, radius);
}

std::optional<Vec3> closest_point(const HalfSpaceProblem& problem, const Vec3& target, double radius) {
  return solve(problem, Vec3::Zero(), target, radius);
}

}  // namespace plico
