#include "plico/shapes/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plico {
namespace {

constexpr int kBlock = 8;  // lattice points along the side of a block that is filled or skipped at once

using Place = std::array<int, 3>;

// Values of the body on a lattice that reaches beyond its box on every side.
class Lattice {
 public:
  Lattice(const SmoothBody& body, double spacing) : spacing_(spacing) {
    origin_ = body.box().min() - Vec3::Constant(2 * spacing);
    for (int k = 0; k < 3; ++k) size_[k] = static_cast<int>(std::ceil(body.box().sizes()[k] / spacing)) + 5;
    value_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
    for (int z = 0; z < size_[2]; z += kBlock)
      for (int y = 0; y < size_[1]; y += kBlock)
        for (int x = 0; x < size_[0]; x += kBlock) fill_block(body, {x, y, z});
  }

  const Place& size() const { return size_; }
  Vec3 point(const Place& p) const { return origin_ + spacing_ * Vec3(p[0], p[1], p[2]); }
  double value(const Place& p) const { return value_[index(p)]; }

 private:
  std::size_t index(const Place& p) const {
    return (static_cast<std::size_t>(p[2]) * size_[1] + p[1]) * size_[0] + p[0];
  }

  // A block whose middle is farther from the surface than its corners can be has one sign.
  void fill_block(const SmoothBody& body, const Place& first) {
    const double half = (kBlock + 1) * spacing_ / 2;
    const double middle = body.value(point(first) + Vec3::Constant(half - spacing_));
    const bool far = std::abs(middle) > body.steepness() * half * std::sqrt(3.0);
    for (int z = first[2]; z < std::min(first[2] + kBlock, size_[2]); ++z)
      for (int y = first[1]; y < std::min(first[1] + kBlock, size_[1]); ++y)
        for (int x = first[0]; x < std::min(first[0] + kBlock, size_[0]); ++x)
          value_[index({x, y, z})] = far ? middle : body.value(point({x, y, z}));
  }

  double spacing_;
  Vec3 origin_;
  Place size_{};
  std::vector<double> value_;
};

// The six tetrahedra of a cube: from corner 0 to corner 7 along its sides in every order. Corner bits are x, y, z. The
// last two of the odd orders are swapped, so that all six have the same orientation.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 1, 7, 5}, {0, 2, 7, 3}, {0, 4, 7, 6}}};

class Marching {
 public:
  explicit Marching(const Lattice& lattice) : lattice_(lattice) {
    const std::size_t layer = static_cast<std::size_t>(lattice.size()[0]) * lattice.size()[1] * 8;
    for (auto& points : point_on_) points.assign(layer, -1);
  }

  PolygonSoup run() {
    const Place& size = lattice_.size();
    for (int z = 0; z + 1 < size[2]; ++z) {
      std::swap(point_on_[0], point_on_[1]);
      std::fill(point_on_[1].begin(), point_on_[1].end(), -1);
      layer_ = z;
      for (int y = 0; y + 1 < size[1]; ++y)
        for (int x = 0; x + 1 < size[0]; ++x) march_cube({x, y, z});
    }
    return std::move(soup_);
  }

 private:
  static Place corner_of(const Place& cube, int bits) {
    return {cube[0] + (bits & 1), cube[1] + (bits >> 1 & 1), cube[2] + (bits >> 2)};
  }
  bool inside(const Place& p) const { return lattice_.value(p) < 0; }

  void march_cube(const Place& cube) {
    int within = 0;
    for (int corner = 0; corner < 8; ++corner) within += inside(corner_of(cube, corner));
    if (within == 0 || within == 8) return;
    for (const auto& tetrahedron : kTetrahedra) march_tetrahedron(cube, tetrahedron);
  }

  // Corners in an even permutation with those inside first; then there are three cases.
  void march_tetrahedron(const Place& cube, std::array<int, 4> t) {
    const auto in = [&](int i) { return inside(corner_of(cube, t[i])); };
    const int within = in(0) + in(1) + in(2) + in(3);
    if (within == 0 || within == 4) return;
    for (int turn = 0; turn < 12 && !sorted(in, within); ++turn) {
      std::rotate(t.begin() + 1, t.begin() + 2, t.end());  // even: a cycle of three
      if (turn % 3 == 2) std::swap(t[0], t[1]), std::swap(t[2], t[3]);
      if (turn == 5) std::swap(t[0], t[2]), std::swap(t[1], t[3]);
    }
    const auto on = [&](int i, int j) { return point_on(cube, t[i], t[j]); };
    if (within == 1) soup_.add_face({on(0, 1), on(0, 2), on(0, 3)});
    if (within == 3) soup_.add_face({on(0, 3), on(1, 3), on(2, 3)});
    if (within == 2) {
      soup_.add_face({on(0, 2), on(0, 3), on(1, 3)});
      soup_.add_face({on(0, 2), on(1, 3), on(1, 2)});
    }
  }

  template <class Inside>
  static bool sorted(const Inside& in, int within) {
    for (int i = 0; i < 4; ++i)
      if (in(i) != (i < within)) return false;
    return true;
  }

  // Lattice edges are kept with their lower corner, by direction; points stay clear of the corners, where many edges
  // meet and triangles would shrink to nothing.
  int point_on(const Place& cube, int a, int b) {
    if (a > b) std::swap(a, b);
    const Place p = corner_of(cube, a), q = corner_of(cube, b);
    const std::size_t place = (static_cast<std::size_t>(p[1]) * lattice_.size()[0] + p[0]) * 8 + (a ^ b);
    int& point = point_on_[p[2] - layer_][place];
    if (point < 0) {
      const double at_p = lattice_.value(p), at_q = lattice_.value(q);
      const double t = std::clamp(at_p / (at_p - at_q), 0.08, 0.92);
      point = soup_.num_points();
      soup_.points.emplace_back(lattice_.point(p) + t * (lattice_.point(q) - lattice_.point(p)));
    }
    return point;
  }

  const Lattice& lattice_;
  std::array<std::vector<int>, 2> point_on_;  // of the lower and the upper layer of the cubes at hand
  int layer_ = 0;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup isosurface(const SmoothBody& body, double spacing) {
  const Lattice lattice(body, spacing);
  return Marching(lattice).run();
}

}  // namespace plico
