#include "plico/origami/closure.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

Vec3 lift(const Vec2& direction) { return {direction.x(), direction.y(), 0}; }

// Axis times angle, angle in [0, pi]. acos of the trace loses half its digits near zero, where foldable states live.
Vec3 rotation_log(const Eigen::Quaterniond& q) {
  const double sine = q.vec().norm();
  if (sine == 0) return Vec3::Zero();
  const Vec3 axis = (q.w() < 0 ? -1.0 : 1.0) / sine * q.vec();
  return 2 * std::atan2(sine, std::abs(q.w())) * axis;
}

// Calls `visit(k, column)` for every crease k with the change of the walk's rotation per radian of it; returns the
// walk's rotation. Translations cancel on a closed walk.
template <class Visit>
Eigen::Quaterniond walk_around(const RealVertex& vertex, const Configuration& config, Visit visit) {
  Eigen::Quaterniond walk = Eigen::Quaterniond::Identity();
  for (std::size_t k = 0; k < vertex.hinges.size(); ++k) {
    const Vec3 axis = lift(vertex.directions[k]);
    visit(k, Vec3(walk * axis));
    walk = walk * Eigen::Quaterniond(Eigen::AngleAxisd(config[vertex.hinges[k]], axis));
  }
  return walk;
}

Eigen::VectorXd residuals(const std::vector<RealVertex>& vertices, const Configuration& config) {
  Eigen::VectorXd result(3 * vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    result.segment<3>(3 * v) = rotation_log(walk_around(vertices[v], config, [](std::size_t, const Vec3&) {}));
  return result;
}

Sparse jacobian(const std::vector<RealVertex>& vertices, const Configuration& config) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    walk_around(vertices[v], config, [&](std::size_t k, const Vec3& column) {
      for (int i = 0; i < 3; ++i)  // zeros too: the pattern must be the same for every configuration
        entries.emplace_back(static_cast<int>(3 * v) + i, vertices[v].hinges[k], column[i]);
    });
  Sparse result(static_cast<int>(3 * vertices.size()), static_cast<int>(config.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Closure summary(const std::vector<RealVertex>& vertices, const Eigen::VectorXd& residual) {
  Closure result;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double angle = result.residual.emplace_back(residual.segment<3>(3 * v).norm());
    if (result.worst_vertex >= 0 && angle <= result.worst) continue;
    result.worst = angle;
    result.worst_vertex = vertices[v].vertex;
  }
  return result;
}

struct Step {
  Configuration config;
  Eigen::VectorXd residual;
};

// The longest of `direction`, half of it, a quarter ... that makes the residual smaller; the input when none does.
Step descend(const std::vector<RealVertex>& vertices, const Step& from, const Eigen::VectorXd& direction) {
  for (double length = 1; length > 1e-4; length /= 2) {
    Step next{from.config + length * direction, {}};
    next.residual = residuals(vertices, next.config);
    if (next.residual.squaredNorm() < from.residual.squaredNorm()) return next;
  }
  return from;
}

void check(const std::vector<RealVertex>& vertices, const Configuration& config) {
  for (const RealVertex& vertex : vertices)
    for (int h : vertex.hinges)
      if (h >= config.size())
        throw InvalidInput("origami/too-few-angles",
                           fmt::format("{} fold angles, crease {} asked for", config.size(), h),
                           fmt::format("vertex {}", vertex.vertex));
}

}  // namespace

std::vector<RealVertex> real_vertices(const CreasePattern& sheet) {
  const std::vector<int> hinge = hinge_of_edge(sheet);
  std::vector<std::vector<int>> edges(sheet.vertices.size());
  for (int e = 0; e < sheet.num_edges(); ++e) {
    edges[sheet.edges[e].a].push_back(e);
    edges[sheet.edges[e].b].push_back(e);
  }
  const auto direction = [&](int e, int v) -> Vec2 {
    const int other = sheet.edges[e].a == v ? sheet.edges[e].b : sheet.edges[e].a;
    return (sheet.vertices[other] - sheet.vertices[v]).normalized();
  };
  std::vector<RealVertex> result;
  for (int v = 0; v < sheet.num_vertices(); ++v) {
    std::vector<int>& around = edges[v];
    if (around.empty() || std::any_of(around.begin(), around.end(), [&](int e) { return hinge[e] < 0; })) continue;
    const auto turn = [&](int e) { return std::atan2(direction(e, v).y(), direction(e, v).x()); };
    std::sort(around.begin(), around.end(), [&](int e, int f) { return turn(e) < turn(f); });
    RealVertex& vertex = result.emplace_back();
    vertex.vertex = v;
    for (int e : around) {
      vertex.hinges.push_back(hinge[e]);
      vertex.directions.push_back(direction(e, v));
    }
  }
  return result;
}

Closure closure(const std::vector<RealVertex>& vertices, const Configuration& config) {
  check(vertices, config);
  return summary(vertices, residuals(vertices, config));
}

Projection project(const std::vector<RealVertex>& vertices, const Configuration& start, const ProjectOptions& options) {
  check(vertices, start);
  Step at{start, residuals(vertices, start)};
  Eigen::SimplicialLDLT<Sparse> solver;
  Projection result;
  result.closure = summary(vertices, at.residual);
  while (result.closure.worst > options.tolerance && result.steps < options.max_steps) {
    const Sparse j = jacobian(vertices, at.config);
    Sparse normal = j.transpose() * j;
    for (int i = 0; i < normal.cols(); ++i) normal.coeffRef(i, i) += options.damping;
    if (result.steps == 0) solver.analyzePattern(normal);
    solver.factorize(normal);
    Eigen::VectorXd direction = solver.solve(-(j.transpose() * at.residual));
    const double longest = direction.cwiseAbs().maxCoeff();
    if (longest > options.max_step) direction *= options.max_step / longest;
    Step next = descend(vertices, at, direction);
    ++result.steps;
    const bool stuck = next.config == at.config;
    at = std::move(next);
    result.closure = summary(vertices, at.residual);
    if (stuck) break;
  }
  result.config = std::move(at.config);
  result.closed = result.closure.worst <= options.tolerance;
  return result;
}

}  // namespace plico
