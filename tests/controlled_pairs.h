// Two bars that overlap, in seven families: the controlled study of [Xi17] fig. 5.15 with bars whose sizes are known.
#pragma once
#include <fmt/core.h>

#include <string>
#include <vector>

#include "plico/base/libm.h"
#include "plico/geom/convex3.h"

namespace plico {

struct ControlledPair {
  std::string family, name;
  ConvexPolyhedron first, second;
  // Percent, eq. 5.8: the best of 400 normals in another program, rounded to three digits, or known in closed form.
  double least_loss;
};

// A box of this size with its low x end at -behind, centered in y and z, turned about the origin, then moved.
inline ConvexPolyhedron bar(const Vec3& size, double behind, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity(),
                            const Vec3& shift = Vec3::Zero()) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(
        turn * Vec3((i & 1 ? size.x() : 0) - behind, (i & 2 ? 0.5 : -0.5) * size.y(), (i & 4 ? 0.5 : -0.5) * size.z()) +
        shift);
  return convex_hull(points);
}

inline Eigen::Matrix3d turned(double degree, const Vec3& axis) { return rotation(axis.normalized(), radians(degree)); }

inline std::vector<ControlledPair> controlled_pairs() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const ConvexPolyhedron end = bar({5, 1, 1}, 0.5), middle = bar({5, 1, 1}, 2.5);
  std::vector<ControlledPair> pairs;
  const auto add = [&](const char* family, std::string name, const ConvexPolyhedron& a, ConvexPolyhedron b,
                       double loss) {
    pairs.push_back({family, std::move(name), a, std::move(b), loss});
  };
  const double elbow_angle[] = {20, 40, 60, 80, 90, 100, 120, 140, 160};
  const double elbow[] = {.762, .964, .859, .407, 0, .203, .426, .467, .341};
  for (int i = 0; i < 9; ++i)
    add("elbow", fmt::format("{} deg", elbow_angle[i]), end, bar({5, 1, 1}, 0.5, turned(elbow_angle[i], z)), elbow[i]);
  const double uneven[] = {.003, .004, 0, .183, .275};
  for (int i = 0; i < 5; ++i)
    add("uneven elbow", fmt::format("{} deg", 30 + 30 * i), end,
        bar({4, .7, .6}, .35, turned(30 + 30 * i, {.2, .3, 1})), uneven[i]);
  const double cross_end[] = {2.660, 3.143, 2.194, 1.748, 1.348};
  const double angle[] = {10, 20, 35, 50, 70};
  for (int i = 0; i < 5; ++i)
    add("cross-end", fmt::format("{} deg", angle[i]), end,
        bar({5, 1, 1}, .9, turned(angle[i], z) * turned(angle[i] / 2, y)), cross_end[i]);
  const double overlap[] = {.2, .5, 1, 2}, end_overlap[] = {.113, .274, .519, 1.237};
  for (int i = 0; i < 4; ++i)
    add("end-overlap", fmt::format("length {}", overlap[i]), bar({5, 1, 1}, 5),
        bar({5, .9, .9}, 2.5, turned(6, {1, 2, 3}), {2.5 - overlap[i], .1, .05}), end_overlap[i]);
  for (double sunk : {.15, .35, .55, .75})
    for (double tilt : {0, 20, 40})
      add("T", fmt::format("sunk {}, tilt {}", sunk, tilt), middle,
          bar({4, .8, .8}, sunk, turned(tilt, y) * turned(-90, y), {0, 0, .5}), 0);
  // Parallel faces: a plane between them takes 5 t of both bars, of which t / sin is shared and lost only once.
  for (double t : {.1, .25, .5})
    for (double degree : {30, 60, 90}) {
      const double square = 1 / plico::sin(radians(degree));
      add("stacked cross", fmt::format("{} deg, {} deep", degree, t), middle,
          bar({5, 1, 1}, 2.5, turned(degree, z), {0, 0, 1 - t}), 100 * t * (5 - square) / (10 - t * square));
    }
  const double through[] = {13.952, 13.089, 6.138, 16.534, 14.178, 5.009, 16.966, 14.421, 5.166};
  for (int i = 0; i < 9; ++i) {
    const int degree = 30 + 30 * (i / 3);
    const double offset[] = {0, 1.2, 1.9};
    add("X", fmt::format("{} deg, offset {}", degree, offset[i % 3]), middle,
        bar({5, .8, .8}, 2.5, turned(degree, z) * turned(15, x), {offset[i % 3], 0, .05}), through[i]);
  }
  return pairs;
}

}  // namespace plico
