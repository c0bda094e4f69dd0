#include "plico/inflate/inflate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "plico/base/error.h"
#include "plico/inflate/explicit.h"
#include "plico/inflate/minimize.h"
#include "plico/inflate/obstacles.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kFirstPressure = 1e-3, kRise = 1.5;
constexpr int kMaxLevels = 60;   // 1e-3 to 2e7
constexpr int kMaxHolds = 12;    // rounds of holding vertices back at one level
constexpr int kBisections = 14;  // of the last level, down to the growth allowed

void require_inflatable(const Mesh& mesh) {
  if (!is_closed(mesh))
    throw InvalidInput("inflate/boundary", "a mesh with a boundary holds no air", {}, "close its holes");
  for (FaceId f : mesh.faces())
    if (mesh.degree(f) != 3)
      throw InvalidInput("inflate/polygon", fmt::format("a face with {} corners would not stay flat", mesh.degree(f)),
                         describe_face(mesh.soup(), f), "triangulate the mesh");
  if (!(volume(mesh) > 0))
    throw InvalidInput("inflate/volume", fmt::format("the volume is {:.3g}, and must be above 0", volume(mesh)), {},
                       "'plico check' says whether faces are turned inside out");
}

// One inflation from pressure to pressure.
class Pump {
 public:
  Pump(const Mesh& mesh, const InflateOptions& options, const Run& run)
      : mesh_(mesh),
        options_(options),
        run_(run),
        energy_(mesh, options.skin, options.keep),
        obstacles_(mesh),
        x_(energy_.start()) {}

  Inflation inflate() {
    result_.hyperbolic_before = count_hyperbolic(mesh_);
    result_.hyperbolic = result_.hyperbolic_before;
    result_.points = mesh_.soup().points;
    result_.limit = rise();
    if (result_.limit == InflateLimit::Hyperbolic) result_.ending = Ending::Found;
    if (result_.limit == InflateLimit::Time) result_.ending = run_.ending();
    std::sort(result_.held.begin(), result_.held.end());
    return std::move(result_);
  }

 private:
  InflateLimit rise() {
    if (result_.hyperbolic <= options_.until_hyperbolic) return InflateLimit::Hyperbolic;
    double pressure = kFirstPressure;
    for (int level = 0; level < kMaxLevels; ++level, pressure *= kRise) {
      const bool last = options_.pressure > 0 && pressure >= options_.pressure;
      const double now = last ? options_.pressure : pressure;
      Eigen::VectorXd next = x_;
      if (!settle(now, next)) return run_.over() ? InflateLimit::Time : InflateLimit::Blocked;
      if (growth(next) > options_.max_growth) return squeeze(now);
      accept(now, next);
      if (result_.hyperbolic <= options_.until_hyperbolic) return InflateLimit::Hyperbolic;
      if (last) return InflateLimit::Pressure;
      run_.report("inflation", result_.hyperbolic_before - result_.hyperbolic, result_.hyperbolic_before);
    }
    return InflateLimit::Pressure;
  }

  // Minimizes at this pressure from x; where faces meet that must not, their vertices go back and are held.
  bool settle(double pressure, Eigen::VectorXd& x) {
    for (int round = 0; round < kMaxHolds && !run_.over(); ++round) {
      Eigen::VectorXd next = x;
      result_.steps += minimize([&](const Eigen::VectorXd& at, Eigen::VectorXd& g) { return energy_(pressure, at, g); },
                                next, {.max_iterations = 400, .tolerance = 1e-5}, run_);
      const std::vector<int> faces = obstacles_.faces_in_the_way(energy_.points(next));
      if (faces.empty()) {
        x = next;
        return !run_.over();
      }
      if (!hold(faces)) return false;
    }
    return false;
  }

  // False when all of their vertices are held already.
  bool hold(const std::vector<int>& faces) {
    const std::size_t before = result_.held.size();
    for (int f : faces)
      for (int v : mesh_.corners(FaceId(f))) {
        if (energy_.is_fixed(VertexId(v))) continue;
        energy_.fix(VertexId(v));
        result_.held.push_back(VertexId(v));
      }
    return result_.held.size() > before;
  }

  // The last level made the mesh grow too much: bisects the pressure.
  InflateLimit squeeze(double too_high) {
    double low = result_.pressure;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + too_high) / 2;
      Eigen::VectorXd next = x_;
      if (!settle(middle, next)) return run_.over() ? InflateLimit::Time : InflateLimit::Blocked;
      if (growth(next) > options_.max_growth) {
        too_high = middle;
        continue;
      }
      low = middle;
      accept(middle, next);
      if (result_.hyperbolic <= options_.until_hyperbolic) return InflateLimit::Hyperbolic;
    }
    return InflateLimit::Growth;
  }

  void accept(double pressure, const Eigen::VectorXd& x) {
    x_ = x;
    result_.pressure = pressure;
    PolygonSoup soup = mesh_.soup();
    soup.points = result_.points = energy_.points(x);
    const Mesh now(std::move(soup));
    result_.hyperbolic = count_hyperbolic(now);
    energy_.classify(now);
  }

  double growth(const Eigen::VectorXd& x) const { return energy_.volume(x) / energy_.start_volume() - 1; }

  const Mesh& mesh_;
  const InflateOptions& options_;
  const Run& run_;
  SkinEnergy energy_;
  Obstacles obstacles_;
  Eigen::VectorXd x_;
  Inflation result_;
};

}  // namespace

void check(const InflateOptions& options) {
  check(options.skin);
  require(options.max_growth > 0 && options.max_growth <= 100, "max-growth", options.max_growth, "in (0, 100]");
  require(options.until_hyperbolic >= 0, "until-hyperbolic", options.until_hyperbolic, "at least 0");
  require(options.pressure >= 0, "pressure", options.pressure, "at least 0");
  require(options.time_step > 0, "time-step", options.time_step, "above 0");
  require(options.max_steps >= 1, "max-steps", options.max_steps, "at least 1");
}

std::string_view name(InflateLimit limit) {
  constexpr std::array<std::string_view, 7> kNames{"hyperbolic", "growth",  "pressure", "steps",
                                                   "burst",      "blocked", "time"};
  return kNames.at(static_cast<std::size_t>(limit));
}

double Inflation::mean_move() const {
  return move.empty() ? 0 : std::accumulate(move.begin(), move.end(), 0.0) / static_cast<double>(move.size());
}

double Inflation::largest_move() const { return move.empty() ? 0 : *std::max_element(move.begin(), move.end()); }

int count_hyperbolic(const Mesh& mesh) {
  int count = 0;
  for (VertexId v : mesh.vertices()) count += is_hyperbolic(mesh, v);
  return count;
}

Inflation inflate(const Mesh& mesh, const InflateOptions& options, const Run& run) {
  check(options);
  require_inflatable(mesh);
  for (FaceId f : options.keep) require(f >= 0 && f < mesh.num_faces(), "keep", int(f), "a face of the mesh");
  Inflation result =
      options.method == InflateMethod::Explicit ? integrate(mesh, options, run) : Pump(mesh, options, run).inflate();
  PolygonSoup soup = mesh.soup();
  soup.points = result.points;
  result.volume_before = volume(mesh);
  result.volume = volume(Mesh(std::move(soup)));
  for (VertexId v : mesh.vertices()) result.move.push_back((result.points[v] - mesh.point(v)).norm());
  return result;
}

}  // namespace plico
