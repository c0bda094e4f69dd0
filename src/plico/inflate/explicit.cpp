#include "plico/inflate/explicit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/inflate/obstacles.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr int kLookEvery = 10;     // steps between looks at the whole mesh
constexpr double kFarthest = 0.5;  // mean edges that a vertex may go in one step

Mesh moved(const Mesh& mesh, std::vector<Vec3> points) {
  PolygonSoup soup = mesh.soup();
  soup.points = std::move(points);
  return Mesh(std::move(soup));
}

// Eq. 4.1: of each vertex, along the normals of its faces, weighted by their angles.
Eigen::VectorXd pressure_forces(const Mesh& now, double pressure) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * now.num_vertices());
  for (FaceId f : now.faces())
    for (HalfedgeId h : now.halfedges(f))
      force.segment<3>(3 * now.from(h)) += pressure * corner_angle(now, h) * normal(now, f);
  return force;
}

// Did the step tear the skin?
bool bursts(const Eigen::VectorXd& step) { return !(step.lpNorm<Eigen::Infinity>() < kFarthest); }

}  // namespace

Inflation integrate(const Mesh& mesh, const InflateOptions& options, const Run& run) {
  InflateOptions printed = options;
  printed.skin.flattening = 0;
  SkinEnergy energy(mesh, printed.skin, options.keep);
  const Obstacles obstacles(mesh);
  Inflation result;
  result.points = mesh.soup().points;
  result.pressure = options.pressure > 0 ? options.pressure : 1;
  result.hyperbolic_before = result.hyperbolic = count_hyperbolic(mesh);
  result.limit = InflateLimit::Steps;
  Eigen::VectorXd x = energy.start(), gradient(x.size());
  Mesh now = mesh;
  for (; result.steps < options.max_steps; ++result.steps) {
    if (result.steps % kLookEvery == 0) {
      now = moved(mesh, energy.points(x));
      if (std::abs(energy.volume(x) / energy.start_volume() - 1) > options.max_growth)
        result.limit = InflateLimit::Growth;
      if (!obstacles.faces_in_the_way(now.soup().points).empty()) result.limit = InflateLimit::Blocked;
      if (run.over()) result.limit = InflateLimit::Time;
      if (result.limit != InflateLimit::Steps) break;
      result.points = now.soup().points;
      result.hyperbolic = count_hyperbolic(now);
      energy.classify(now);
      if (result.hyperbolic <= options.until_hyperbolic) result.limit = InflateLimit::Hyperbolic;
      if (result.limit != InflateLimit::Steps) break;
    }
    energy(0, x, gradient);
    const Eigen::VectorXd step =
        options.time_step * (energy.only_free(pressure_forces(now, result.pressure)) - gradient);
    if (bursts(step)) {
      result.limit = InflateLimit::Burst;
      break;
    }
    x += step;
  }
  if (result.limit == InflateLimit::Hyperbolic) result.ending = Ending::Found;
  if (result.limit == InflateLimit::Time) result.ending = run.ending();
  return result;
}

}  // namespace plico
