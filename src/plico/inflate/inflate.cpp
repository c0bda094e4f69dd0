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
constexpr int kPatience = 7;     // levels without a vertex less, 17 times the pressure

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
        x_(energy_.start()) {
    energy_.hold_volume(options.max_growth / 2);
    for (VertexId v : options.keep_vertices) energy_.fix(v);
  }

  Inflation inflate() {
    result_.hyperbolic_before = result_.hyperbolic = count_hyperbolic(mesh_);
    result_.points = mesh_.soup().points;
    result_.flattening = options_.skin.flattening;
    result_.limit = rise();
    if (result_.limit == InflateLimit::Hyperbolic) result_.ending = Ending::Found;
    if (result_.limit == InflateLimit::Time) result_.ending = run_.ending();
    std::sort(result_.held.begin(), result_.held.end());
    return std::move(result_);
  }

 private:
  InflateLimit rise() {
    if (is_enough()) return InflateLimit::Hyperbolic;
    double pressure = kFirstPressure;
    for (int level = 0; level < kMaxLevels; ++level, pressure *= kRise) {
      const bool last = options_.pressure > 0 && pressure >= options_.pressure;
      const double now = last ? options_.pressure : pressure;
      Eigen::VectorXd next = x_;
      if (!settle(now, next)) return run_.over() ? InflateLimit::Time : InflateLimit::Blocked;
      if (change(next) > options_.max_growth) return squeeze(now);
      accept(now, next);
      if (is_enough()) return InflateLimit::Hyperbolic;
      if (last) return InflateLimit::Pressure;
      if (++levels_since_best_ > kPatience) return InflateLimit::Settled;
      run_.report("inflation", result_.hyperbolic_before - result_.hyperbolic, result_.hyperbolic_before);
    }
    return InflateLimit::Pressure;
  }

  bool is_enough() const { return result_.hyperbolic <= options_.until_hyperbolic; }

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

  // The last level changed the volume too much: bisects the pressure.
  InflateLimit squeeze(double too_high) {
    double low = pressure_;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + too_high) / 2;
      Eigen::VectorXd next = x_;
      if (!settle(middle, next)) return run_.over() ? InflateLimit::Time : InflateLimit::Blocked;
      if (change(next) > options_.max_growth) {
        too_high = middle;
        continue;
      }
      low = middle;
      accept(middle, next);
      if (is_enough()) return InflateLimit::Hyperbolic;
    }
    return InflateLimit::Growth;
  }

  // Goes on from here, and remembers the best.
  void accept(double pressure, const Eigen::VectorXd& x) {
    x_ = x;
    pressure_ = pressure;
    PolygonSoup soup = mesh_.soup();
    soup.points = energy_.points(x);
    const Mesh now(soup);
    const std::vector<char> is_hyperbolic = hyperbolic_vertices(now);
    energy_.classify(now, is_hyperbolic);
    const int hyperbolic = count_hyperbolic(is_hyperbolic);
    if (std::pair(hyperbolic, change(x)) >= std::pair(result_.hyperbolic, best_change_)) return;
    if (hyperbolic < result_.hyperbolic) levels_since_best_ = 0;
    best_change_ = change(x);
    result_.hyperbolic = hyperbolic;
    result_.pressure = pressure;
    result_.points = std::move(soup.points);
  }

  double change(const Eigen::VectorXd& x) const { return std::abs(energy_.volume(x) / energy_.start_volume() - 1); }

  const Mesh& mesh_;
  const InflateOptions& options_;
  const Run& run_;
  SkinEnergy energy_;
  Obstacles obstacles_;
  Eigen::VectorXd x_;
  double pressure_ = 0, best_change_ = 0;  // of x_; of the volume of the best
  int levels_since_best_ = 0;
  Inflation result_;
};

bool is_better(const Inflation& a, const Inflation& b) {
  const auto cost = [](const Inflation& i) { return std::pair(i.hyperbolic, std::abs(i.volume - i.volume_before)); };
  return cost(a) < cost(b);
}

Mesh moved_mesh(const Mesh& mesh, const std::vector<Vec3>& points) {
  PolygonSoup soup = mesh.soup();
  soup.points = points;
  return Mesh(std::move(soup));
}

Inflation inflate_once(const Mesh& mesh, const InflateOptions& options, const Run& run) {
  Inflation result =
      options.method == InflateMethod::Explicit ? integrate(mesh, options, run) : Pump(mesh, options, run).inflate();
  const Mesh after = moved_mesh(mesh, result.points);
  result.volume_before = volume(mesh);
  result.volume = volume(after);
  result.excess_before = angle_excess(mesh);
  result.excess = angle_excess(after);
  for (VertexId v : mesh.vertices()) result.move.push_back((result.points[v] - mesh.point(v)).norm());
  return result;
}

}  // namespace

void check(const InflateOptions& options) {
  check(options.skin);
  for (double times : options.stronger) require(times > 0, "stronger", times, "above 0");
  require(options.max_growth > 0 && options.max_growth <= 100, "max-growth", options.max_growth, "in (0, 100]");
  require(options.until_hyperbolic >= 0, "until-hyperbolic", options.until_hyperbolic, "at least 0");
  require(options.pressure >= 0, "pressure", options.pressure, "at least 0");
  require(options.time_step > 0, "time-step", options.time_step, "above 0");
  require(options.max_steps >= 1, "max-steps", options.max_steps, "at least 1");
}

void check(const Mesh& mesh, const InflateOptions& options) {
  check(options);
  require_inflatable(mesh);
  for (FaceId f : options.keep) require(f >= 0 && f < mesh.num_faces(), "keep", int(f), "a face of the mesh");
  for (VertexId v : options.keep_vertices)
    require(v >= 0 && v < mesh.num_vertices(), "keep-vertex", int(v), "a vertex of the mesh");
}

std::string_view name(InflateLimit limit) {
  constexpr std::array<std::string_view, 8> kNames{"hyperbolic", "growth", "pressure", "settled",
                                                   "steps",      "burst",  "blocked",  "time"};
  return kNames.at(static_cast<std::size_t>(limit));
}

double Inflation::mean_move() const {
  return move.empty() ? 0 : std::accumulate(move.begin(), move.end(), 0.0) / static_cast<double>(move.size());
}

double Inflation::largest_move() const { return move.empty() ? 0 : *std::max_element(move.begin(), move.end()); }

int count_hyperbolic(const Mesh& mesh) { return count_hyperbolic(hyperbolic_vertices(mesh)); }

double angle_excess(const Mesh& mesh) {
  double sum = 0;
  for (VertexId v : mesh.vertices())
    if (is_hyperbolic(mesh, v)) sum += angle_sum(mesh, v) - 2 * kPi;
  return sum;
}

Inflation inflate(const Mesh& mesh, const InflateOptions& options, const Run& run) {
  check(mesh, options);
  Inflation best = inflate_once(mesh, options, run);
  if (options.method == InflateMethod::Explicit) return best;
  for (double times : options.stronger) {
    if (best.ending != Ending::Exhausted) break;
    InflateOptions stronger = options;
    stronger.skin.flattening *= times;
    Inflation other = inflate_once(mesh, stronger, run);
    const Ending ending = other.ending;
    if (is_better(other, best)) best = std::move(other);
    best.ending = ending;
  }
  return best;
}

}  // namespace plico
