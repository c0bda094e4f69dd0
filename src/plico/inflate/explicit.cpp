#include "plico/inflate/explicit.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  for (FaceId f : now.faces()) {
    const Vec3 along = normal(now, f);
    for (HalfedgeId h : now.halfedges(f)) force.segment<3>(3 * now.from(h)) += pressure * corner_angle(now, h) * along;
  }
  return force;
}

// Did the step tear the skin?
bool bursts(const Eigen::VectorXd& step) { return !(step.lpNorm<Eigen::Infinity>() < kFarthest); }

SkinOptions without_flattening(SkinOptions skin) {
  skin.flattening = 0;
  return skin;
}

}  // namespace

ExplicitInflation::ExplicitInflation(const Mesh& mesh, const InflateOptions& options)
    : mesh_(mesh),
      options_(options),
      energy_(mesh, without_flattening(options.skin), options.keep),
      obstacles_(mesh),
      x_(energy_.start()),
      gradient_(x_.size()),
      now_(mesh) {
  for (VertexId v : options.keep_vertices) energy_.fix(v);
  result_.pressure = options.pressure > 0 ? options.pressure : 1;
  result_.limit = InflateLimit::Steps;
  result_.points = mesh.soup().points;
  hyperbolic_ = hyperbolic_vertices(mesh);
  result_.hyperbolic_before = count_hyperbolic(hyperbolic_);
  look({});
}

void ExplicitInflation::end(InflateLimit limit) {
  result_.limit = limit;
  ended_ = true;
}

void ExplicitInflation::look(const Run& run) {
  Mesh now = moved(mesh_, energy_.points(x_));
  if (std::abs(energy_.volume(x_) / energy_.start_volume() - 1) > options_.max_growth) return end(InflateLimit::Growth);
  if (!obstacles_.faces_in_the_way(now.soup().points).empty()) return end(InflateLimit::Blocked);
  if (run.over()) return end(InflateLimit::Time);
  now_ = std::move(now);
  result_.points = now_.soup().points;
  pressure_ = energy_.only_free(pressure_forces(now_, result_.pressure));
  hyperbolic_ = hyperbolic_vertices(now_);
  result_.hyperbolic = count_hyperbolic(hyperbolic_);
  energy_.classify(now_, hyperbolic_);
  if (result_.hyperbolic <= options_.until_hyperbolic) return end(InflateLimit::Hyperbolic);
  if (result_.steps >= options_.max_steps) end(InflateLimit::Steps);
}

bool ExplicitInflation::advance(const Run& run) {
  if (ended_) return false;
  for (int i = 0; i < kLookEvery && result_.steps < options_.max_steps; ++i) {
    energy_(0, x_, gradient_);
    const Eigen::VectorXd step = options_.time_step * (pressure_ - gradient_);
    if (bursts(step)) {
      end(InflateLimit::Burst);
      return false;
    }
    x_ += step;
    ++result_.steps;
  }
  look(run);
  return !ended_;
}

Inflation integrate(const Mesh& mesh, const InflateOptions& options, const Run& run) {
  ExplicitInflation inflation(mesh, options);
  while (inflation.advance(run)) {
  }
  Inflation result = inflation.result();
  if (result.limit == InflateLimit::Hyperbolic) result.ending = Ending::Found;
  if (result.limit == InflateLimit::Time) result.ending = run.ending();
  return result;
}

}  // namespace plico
