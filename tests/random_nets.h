// Random shapes and random ways to cut them open, for property tests.
#pragma once
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "plico/base/rng.h"
#include "plico/fold/unfolding.h"

namespace plico {

// A torus of n x m quads, each cut in two, its corners moved at random.
inline Mesh bumpy_torus(Rng& rng, int n, int m) {
  PolygonSoup soup;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * kPi * i / n, v = 2 * kPi * j / m, r = 1 + 0.5 * std::cos(v) + rng.uniform(-0.15, 0.15);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v) + rng.uniform(-0.1, 0.1));
    }
  const auto id = [&](int i, int j) { return i % n * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      soup.add_face({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.add_face({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return Mesh(soup);
}

// A spanning tree of the faces of a closed connected mesh.
inline FoldForest random_tree(const Mesh& mesh, Rng& rng) {
  std::vector<int> edges(mesh.num_edges()), root(mesh.num_faces());
  std::iota(edges.begin(), edges.end(), 0);
  for (int i = mesh.num_edges() - 1; i > 0; --i) std::swap(edges[i], edges[rng.below(i + 1)]);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int f) {
    while (root[f] != f) f = root[f] = root[root[f]];
    return f;
  };
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (int e : edges) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    const int a = find(mesh.face(h)), b = find(mesh.face(mesh.twin(h)));
    if (a == b) continue;
    root[a] = b;
    forest.is_fold[e] = 1;
  }
  return forest;
}

}  // namespace plico
