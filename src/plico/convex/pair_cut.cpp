#include "plico/convex/pair_cut.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "plico/base/libm.h"
#include "plico/convex/svm.h"

namespace plico {
namespace {

using Mat3 = Eigen::Matrix3d;

double loss_of(const CutPair& pair, const Plane& plane) { return cut_loss(pair, frame_of(plane, {0, 0, 0})).value; }

// What two bodies share, and the loop in which their boundaries cross.
struct Overlap {
  static constexpr int kSecond = 1;

  ConvexPolyhedron body;   // facets of the second body are marked kSecond
  std::vector<Vec3> loop;  // corners on both boundaries, in order of number
  Vec3 center;

  explicit Overlap(const CutPair& pair) {
    ConvexPolyhedron first = pair.first;
    for (auto& facet : first.facets) facet.source = ConvexPolyhedron::kOwn;
    body = intersection(std::move(first), pair.second, kSecond);
    center = centroid(body);
    std::vector<int> boundaries(body.points.size(), 0);
    for (const auto& facet : body.facets)
      for (int v : facet.corners) boundaries[v] |= facet.source == kSecond ? 2 : 1;
    for (std::size_t v = 0; v < boundaries.size(); ++v)
      if (boundaries[v] == 3) loop.push_back(body.points[v]);
  }

  // The loop's vector area, which is that of either side it bounds.
  Vec3 loop_area() const {
    Vec3 sum = Vec3::Zero();
    for (const auto& facet : body.facets)
      if (facet.source != kSecond) sum += vector_area(body, facet);
    return sum;
  }
};

// Mean and axes of a cloud of points; the first axis is the shortest.
std::pair<Vec3, Mat3> principal_axes(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  return {mean, Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors()};
}

// The way round that loses less.
Plane better_way(const CutPair& pair, const Plane& plane) {
  const CutLoss loss = cut_loss(pair, frame_of(plane, {0, 0, 0}));
  return loss.flipped < loss.value ? plane.flipped() : plane;
}

Plane least_squares_plane(const CutPair& pair, const Overlap& overlap) {
  const auto [mean, axes] = principal_axes(overlap.loop.size() < 3 ? overlap.body.points : overlap.loop);
  const Vec3 normal = axes.col(0);
  return better_way(pair, {normal, normal.dot(mean)});
}

// The step of least model value g.s + s.H.s / 2 within a ball.
Vec3 trust_region_step(const Vec3& gradient, const Mat3& hessian, double radius) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(hessian);
  const Vec3& curvature = eigen.eigenvalues();
  const Vec3 slope = eigen.eigenvectors().transpose() * gradient;
  const double scale = curvature.cwiseAbs().maxCoeff() + gradient.norm() / radius;
  const auto step = [&](double shift) {
    Vec3 s;
    for (int k = 0; k < 3; ++k) s[k] = -slope[k] / std::max(curvature[k] + shift, 1e-14 * scale);
    return s;
  };
  if (curvature[0] > 0 && step(0).norm() <= radius) return eigen.eigenvectors() * step(0);
  double low = std::max(0.0, -curvature[0]), high = low + scale;
  for (int i = 0; i < 60; ++i) (step((low + high) / 2).norm() > radius ? low : high) = (low + high) / 2;
  Vec3 s = step(high);
  // The slope may vanish along the most curved way down: then any length of it is as good, and the longest best.
  const double left = radius * radius - s.squaredNorm();
  if (curvature[0] < 0 && left > 1e-6 * radius * radius) s[0] += (s[0] < 0 ? -1 : 1) * std::sqrt(left);
  return eigen.eigenvectors() * s;
}

// The plane z = t + a x + b y of a frame.
Plane moved(const PlaneFrame& frame, const Vec3& step) {
  const Vec3 normal = (frame.axes * Vec3(-step[1], -step[2], 1)).normalized();
  return {normal, normal.dot(frame.origin + step[0] * frame.axes.col(2))};
}

double half_diagonal(const ConvexPolyhedron& body) { return bounding_box(body.points).diagonal().norm() / 2; }

// Newton's method for one pair; rotations are measured by how far they move the rim of the smaller body.
class CutDescent {
 public:
  CutDescent(const CutPair& pair, const Vec3& center)
      : pair_(pair),
        center_(center),
        size_(std::min(half_diagonal(pair.first), half_diagonal(pair.second))),
        scale_(1, 1 / size_, 1 / size_) {}

  Plane from(const Plane& plane) const {
    PlaneFrame frame = frame_of(plane, center_);
    CutLoss loss = cut_loss(pair_, frame);
    double radius = size_ / 4;
    for (int i = 0; i < kSteps && radius > 1e-13 * size_; ++i) {
      const Vec3 gradient = scale_.cwiseProduct(loss.gradient);
      const Mat3 hessian = scale_.asDiagonal() * loss.hessian * scale_.asDiagonal();
      const Vec3 step = trust_region_step(gradient, hessian, radius);
      const double promised = -gradient.dot(step) - step.dot(hessian * step) / 2;
      if (!(promised > 1e-15 * size_ * size_ * size_)) break;
      const PlaneFrame next_frame = frame_of(moved(frame, scale_.cwiseProduct(step)), center_);
      const CutLoss next = cut_loss(pair_, next_frame);
      const double gained = loss.value - next.value;
      if (gained < promised / 4) radius = step.norm() / 4;
      if (gained > promised * 3 / 4) radius = std::max(radius, std::min(2 * step.norm(), size_));
      if (gained <= 0) continue;
      frame = next_frame;
      loss = next;
    }
    return frame.plane();
  }

 private:
  static constexpr int kSteps = 80;

  const CutPair& pair_;
  Vec3 center_;
  double size_;
  Vec3 scale_;
};

// The six normals of the search.
std::vector<Vec3> start_normals(const CutPair& pair, const Overlap& overlap) {
  std::vector<Vec3> normals = {overlap.loop_area(), centroid(pair.second) - centroid(pair.first)};
  if (overlap.loop.size() >= 3) normals.push_back(principal_axes(overlap.loop).second.col(0));
  const Mat3 axes = principal_axes(overlap.body.points).second;
  for (int k = 0; k < 3; ++k) normals.push_back(axes.col(k));
  std::vector<Vec3> result;
  for (const Vec3& normal : normals)
    if (normal.norm() > 0) result.push_back(normal.normalized());
  return result;
}

// For one normal the best of a few offsets through the overlap, in each way round.
std::array<Plane, 2> best_samples(const CutPair& pair, const Overlap& overlap, const Vec3& normal) {
  constexpr int kOffsets = 16;
  const auto [low, high] = extent(overlap.body.points, normal);
  std::array<Plane, 2> best;
  std::array<double, 2> least = {INFINITY, INFINITY};
  for (int i = 0; i < kOffsets; ++i) {
    const Plane plane{normal, low + (i + 0.5) / kOffsets * (high - low)};
    const CutLoss loss = cut_loss(pair, frame_of(plane, overlap.center));
    if (loss.value < least[0]) least[0] = loss.value, best[0] = plane;
    if (loss.flipped < least[1]) least[1] = loss.flipped, best[1] = plane.flipped();
  }
  return best;
}

struct JudgedPlane {
  Plane plane;
  double loss = INFINITY;
  double missing = INFINITY;  // volume that the floors ask for and the plane does not leave

  bool operator<(const JudgedPlane& other) const {
    return missing != other.missing ? missing < other.missing : loss < other.loss;
  }
};

// Pairs of which only one body counts, to see what either loses.
CutPair only_first(const CutPair& pair) {
  return {pair.first, pair.second, 1, 0, pair.first_volume, pair.second_volume};
}
CutPair only_second(const CutPair& pair) {
  return {pair.first, pair.second, 0, 1, pair.first_volume, pair.second_volume};
}

JudgedPlane judged(const CutPair& pair, const CutFloor& floor, const Plane& plane) {
  if (floor.first == 0 && floor.second == 0) return {plane, loss_of(pair, plane), 0};
  const double first = loss_of(only_first(pair), plane), second = loss_of(only_second(pair), plane);
  const double missing = std::max(0.0, floor.first - (pair.first_volume - first)) +
                         std::max(0.0, floor.second - (pair.second_volume - second));
  return {plane, pair.first_weight * first + pair.second_weight * second, missing};
}

// -1 when the plane leaves the first body less than its floor, 1 when the second, else 0.
int starved_side(const CutPair& pair, const CutFloor& floor, const Plane& plane) {
  if (floor.first == 0 && floor.second == 0) return 0;
  if (pair.first_volume - loss_of(only_first(pair), plane) < floor.first) return -1;
  return pair.second_volume - loss_of(only_second(pair), plane) < floor.second ? 1 : 0;
}

// The plane moved along its normal as little as leaves the starved body what its floor asks for.
Plane slid(const CutPair& pair, const CutFloor& floor, const Plane& plane) {
  const int starved = starved_side(pair, floor, plane);
  if (starved == 0) return plane;
  const auto& body = starved < 0 ? pair.first : pair.second;
  const auto [low, high] = extent(body.points, plane.normal);
  double bad = plane.offset, good = starved < 0 ? high : low;
  for (int i = 0; i < 40; ++i) {
    const double middle = (bad + good) / 2;
    (starved_side(pair, floor, {plane.normal, middle}) == starved ? bad : good) = middle;
  }
  return {plane.normal, good};
}

// Descends from all starts; `best` becomes the best plane that was seen, slid to its floors. Returns the plane of least
// weighted loss, floors or not.
Plane search(const CutPair& pair, const CutPair& weighted, const Overlap& overlap, const CutFloor& floor,
             JudgedPlane& best) {
  const CutDescent descent(weighted, overlap.center);
  JudgedPlane free;
  for (const Vec3& normal : start_normals(pair, overlap))
    for (const Plane& start : best_samples(weighted, overlap, normal)) {
      const Plane plane = descent.from(start);
      free = std::min(free, judged(weighted, {}, plane));
      best = std::min(best, judged(pair, floor, slid(pair, floor, plane)));
    }
  return free.plane;
}

// Points of a body at equal density: a tetrahedron over a facet by its share, then uniform in it.
std::vector<Vec3> samples(const ConvexPolyhedron& body, int count, Rng& rng) {
  struct Tetrahedron {
    double up_to;
    std::array<Vec3, 3> corners;
  };
  const Vec3 apex = centroid(body);
  std::vector<Tetrahedron> fan;
  double sum = 0;
  for (const auto& facet : body.facets)
    for (std::size_t i = 2; i < facet.corners.size(); ++i) {
      const std::array<Vec3, 3> c = {body.points[facet.corners[0]], body.points[facet.corners[i - 1]],
                                     body.points[facet.corners[i]]};
      sum += std::abs((c[0] - apex).dot((c[1] - apex).cross(c[2] - apex)));
      fan.push_back({sum, c});
    }
  std::vector<Vec3> result;
  for (int i = 0; i < count; ++i) {
    const double pick = rng.uniform(0, sum);
    auto it = std::upper_bound(fan.begin(), fan.end(), pick, [](double v, const auto& t) { return v < t.up_to; });
    if (it == fan.end()) --it;
    std::array<double, 3> u;
    for (double& x : u) x = rng.uniform();
    std::sort(u.begin(), u.end());
    const auto& c = it->corners;
    result.push_back(u[0] * c[0] + (u[1] - u[0]) * c[1] + (u[2] - u[1]) * c[2] + (1 - u[2]) * apex);
  }
  return result;
}

Plane svm_cut(const CutPair& pair, const Overlap& overlap, Rng& rng, const SvmOptions& options) {
  const double first = volume(pair.first), second = volume(pair.second);
  const int below =
      std::clamp(static_cast<int>(std::lround(options.samples * first / (first + second))), 5, options.samples - 5);
  std::vector<Vec3> low = samples(pair.first, below, rng);
  std::vector<Vec3> high = samples(pair.second, options.samples - below, rng);
  const double scale = plico::pow(100 / (first + second - volume(overlap.body)), 1.0 / 3);
  for (auto* side : {&low, &high})
    for (Vec3& p : *side) p = scale * (p - overlap.center);
  const std::optional<Plane> plane = svm_plane(low, high, options.penalty);
  if (!plane) return least_squares_plane(pair, overlap);
  return {plane->normal, plane->offset / scale + plane->normal.dot(overlap.center)};
}

// Roots of the parabola through three values at 1/6, 1/2, 5/6, inside [0, 1].
std::vector<double> parabola_roots(double a, double b, double c) {
  const double bend = (a - 2 * b + c) / 2, slope = (c - a) / 2;  // in units of 1/3 from the middle
  std::vector<double> roots;
  if (bend == 0) {
    if (slope != 0) roots = {-b / slope};
  } else if (const double disc = slope * slope - 4 * bend * b; disc >= 0) {
    const double q = -(slope + (slope < 0 ? -1 : 1) * std::sqrt(disc)) / 2;
    roots = {q / bend};
    if (q != 0) roots.push_back(b / q);
  }
  std::vector<double> inside;
  for (double r : roots)
    if (std::abs(r) <= 1.5) inside.push_back(0.5 + r / 3);
  return inside;
}

}  // namespace

std::string_view name(CutMethod method) {
  switch (method) {
    case CutMethod::Lsf:
      return "lsf";
    case CutMethod::Svm:
      return "svm";
    case CutMethod::SvmOffset:
      return "svm-offset";
    case CutMethod::Full:
      break;
  }
  return "full";
}

Plane best_offset(const CutPair& pair, const Vec3& normal) {
  std::vector<double> knots;
  for (const auto* body : {&pair.first, &pair.second})
    for (const Vec3& p : body->points) knots.push_back(normal.dot(p));
  std::sort(knots.begin(), knots.end());
  const auto at = [&](double offset) { return cut_loss(pair, frame_of({normal, offset}, {0, 0, 0})); };
  Plane best{normal, knots.front()};
  double least = INFINITY;
  const auto consider = [&](double offset) {
    if (const double value = at(offset).value; value < least) least = value, best.offset = offset;
  };
  const double tiny = 1e-12 * (knots.back() - knots.front());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double low = knots[i], width = knots[i + 1] - low;
    consider(low);
    if (width <= tiny) continue;
    const auto slope = [&](double share) { return at(low + share * width).gradient[0]; };
    for (double share : parabola_roots(slope(1.0 / 6), slope(0.5), slope(5.0 / 6))) consider(low + share * width);
  }
  consider(knots.back());
  return best;
}

Plane polished_cut(const CutPair& pair, const Plane& start) {
  return CutDescent(pair, (centroid(pair.first) + centroid(pair.second)) / 2).from(start);
}

Plane full_cut(const CutPair& pair, const CutFloor& floor) {
  const Overlap overlap(pair);
  JudgedPlane best;
  Plane free = search(pair, pair, overlap, floor, best);
  for (double more = 2; more <= 16; more *= 2) {  // the starved side counts more and more
    const int starved = starved_side(pair, floor, free);
    if (starved == 0) break;
    const CutPair heavier{pair.first, pair.second, pair.first_weight * (starved < 0 ? more : 1),
                          pair.second_weight * (starved < 0 ? 1 : more)};
    free = search(pair, heavier, overlap, floor, best);
  }
  return best.plane;
}

Plane cut_plane(const CutPair& pair, CutMethod method, Rng& rng, const SvmOptions& svm) {
  if (method == CutMethod::Full) return full_cut(pair);
  const Overlap overlap(pair);
  if (method == CutMethod::Lsf) return least_squares_plane(pair, overlap);
  const Plane plane = svm_cut(pair, overlap, rng, svm);
  return method == CutMethod::Svm ? plane : best_offset(pair, plane.normal);
}

}  // namespace plico
