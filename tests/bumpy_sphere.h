// A closed mesh for tests that is neither convex nor regular.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "plico/base/rng.h"
#include "plico/mesh/mesh.h"

namespace plico {

// An octahedron, subdivided: 8 * 4^levels triangles, radii in [1 - bumps, 1 + bumps].
inline Mesh bumpy_sphere(int levels, double bumps, std::uint64_t seed) {
  PolygonSoup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [at, added] = middle.emplace(std::minmax(a, b), soup.num_points());
      if (added) soup.points.push_back((soup.points[a] + soup.points[b]).normalized());
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
  for (Vec3& p : soup.points) p *= 1 + rng.uniform(-bumps, bumps);
  for (const auto& face : faces) soup.add_face({face[0], face[1], face[2]});
  return Mesh(soup);
}

}  // namespace plico
