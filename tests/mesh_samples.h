// Small meshes for tests.
#pragma once
#include <cmath>
#include <map>
#include <numeric>

#include "plico/base/rng.h"
#include "plico/mesh/mesh.h"
#include "plico/shapes/shapes.h"

namespace plico {

inline Mesh tetrahedron_mesh() { return Mesh(tetrahedron()); }

// An icosahedron whose faces are split in four `level` times; vertices are pushed off the sphere by up to `bump`.
inline Mesh bumpy_sphere(int level, double bump, std::uint64_t seed) {
  const double t = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                              {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  std::vector<std::array<int, 3>> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < level; ++i) {
    std::map<std::pair<int, int>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [at, added] = middle.emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (added) points.push_back((points[a] + points[b]) / 2);
      return at->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const int ab = split(a, b), bc = split(b, c), ca = split(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  Rng rng(seed);
  PolygonSoup soup;
  for (const Vec3& p : points) soup.points.push_back(p.normalized() * (1 + bump * rng.uniform(-1, 1)));
  for (const auto& face : faces) soup.add_face(face);
  return Mesh(soup);
}

// `faces` triangles with a corner of `angle` radians at one common inner vertex: an open fan that dives and rises so
// that it closes. With an angle sum above 2 pi it is a saddle that no single net can lay flat.
inline Mesh saddle_fan(int faces, double angle) {
  PolygonSoup soup;
  soup.points.emplace_back(0, 0, 0);
  // Unit spokes at equal turns around z, up and down in turn by the slope that makes neighbours meet at `angle`.
  const double turn = 2 * kPi / faces;  // `faces` is even
  const double rise = std::asin(std::sqrt((std::cos(turn) - std::cos(angle)) / (1 + std::cos(turn))));
  for (int i = 0; i < faces; ++i) {
    const double up = (i % 2 ? 1 : -1) * rise;
    soup.points.emplace_back(std::cos(up) * std::cos(i * turn), std::cos(up) * std::sin(i * turn), std::sin(up));
  }
  for (int i = 0; i < faces; ++i) soup.add_face({0, 1 + i, 1 + (i + 1) % faces});
  return Mesh(soup);
}

}  // namespace plico
