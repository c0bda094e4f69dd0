// Small shapes and their nets for the tests of sheets: convex and not, triangles to octagons, panels that are not
// convex, holes through the model.
#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "plico/base/rng.h"
#include "plico/fabricate/page.h"
#include "plico/shapes/shapes.h"
#include "plico/unfold/search.h"

namespace plico::samples {

struct Shape {
  std::string name;
  Mesh mesh;
};

inline Mesh mesh_of(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  PolygonSoup soup;
  soup.points = points;
  for (const auto& face : faces) soup.add_face(face);
  return Mesh(soup);
}

inline Mesh cube(double side = 1) {
  const double s = side;
  return mesh_of({{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}, {0, 0, s}, {s, 0, s}, {s, s, s}, {0, s, s}},
                 {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// A right prism over a polygon, height h.
inline Mesh prism(const std::vector<Vec2>& base, double h) {
  const int n = static_cast<int>(base.size());
  std::vector<Vec3> points;
  for (double z : {0.0, h})
    for (const Vec2& p : base) points.emplace_back(p.x(), p.y(), z);
  std::vector<std::vector<int>> faces(2);
  for (int i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return mesh_of(points, faces);
}

inline std::vector<Vec2> regular(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) points.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n));
  return points;
}

inline Mesh pyramid(int n, double h) {
  std::vector<Vec3> points;
  for (const Vec2& p : regular(n)) points.emplace_back(p.x(), p.y(), 0);
  points.emplace_back(0, 0, h);
  std::vector<std::vector<int>> faces(1);
  for (int i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces.push_back({i, (i + 1) % n, n});
  }
  return mesh_of(points, faces);
}

// A ball of m rings of n vertices, triangles; radius(vertex) makes it a star.
inline Mesh ball(int m, int n, const std::function<double(int)>& radius) {
  std::vector<Vec3> points{{0, 0, -radius(0)}};
  for (int i = 1; i <= m; ++i)
    for (int j = 0; j < n; ++j) {
      const double t = kPi * i / (m + 1) - kPi / 2, a = 2 * kPi * j / n, r = radius(static_cast<int>(points.size()));
      points.emplace_back(r * std::cos(t) * std::cos(a), r * std::cos(t) * std::sin(a), r * std::sin(t));
    }
  const int top = static_cast<int>(points.size());
  points.emplace_back(0, 0, radius(top));
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < n; ++j) {
    const int k = (j + 1) % n;
    faces.push_back({0, 1 + k, 1 + j});
    for (int i = 0; i + 1 < m; ++i) {
      const int a = 1 + i * n;
      faces.push_back({a + j, a + k, a + n + k});
      faces.push_back({a + j, a + n + k, a + n + j});
    }
    faces.push_back({1 + (m - 1) * n + j, 1 + (m - 1) * n + k, top});
  }
  return mesh_of(points, faces);
}

inline Mesh torus(int m, int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = 2 * kPi * i / m, b = 2 * kPi * j / n, r = 1 + 0.4 * std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b));
    }
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * n + j, b = (i + 1) % m * n + j, c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  return mesh_of(points, faces);
}

inline std::vector<Shape> shapes() {
  std::vector<Shape> all{{"cube", cube()}};
  for (int n : {3, 5, 6, 8}) all.push_back({"prism-" + std::to_string(n), prism(regular(n), 1.5)});
  for (int n : {3, 4, 5, 7}) all.push_back({"pyramid-" + std::to_string(n), pyramid(n, 1.2)});
  all.push_back({"needle", pyramid(6, 9)});
  all.push_back({"letter-l", prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.8)});
  all.push_back({"letter-u", prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 1.0)});
  all.push_back({"star-prism", prism({{3, 0}, {1, 1}, {0, 3}, {-1, 1}, {-3, 0}, {-1, -1}, {0, -3}, {1, -1}}, 1.0)});
  for (int n : {4, 6, 9}) all.push_back({"ball-" + std::to_string(n), ball(n / 2 + 1, n, [](int) { return 1.0; })});
  for (int n : {3, 5, 8}) all.push_back({"torus-" + std::to_string(n), torus(n + 2, n)});
  for (int seed = 1; seed <= 5; ++seed) {
    const auto radius = [seed](int v) { return Rng(seed).stream(v).uniform(0.5, 1.3); };
    all.push_back({"star-" + std::to_string(seed), ball(3 + seed, 7, radius)});
  }
  const double golden = (1 + std::sqrt(5.0)) / 2;
  all.push_back({"dodecahedron", Mesh(dodecahedron())});
  all.push_back({"football", Mesh(truncated(Mesh(icosahedron()), 3))});
  all.push_back({"small-stellated-dodecahedron", Mesh(spiked(Mesh(dodecahedron()), golden))});
  all.push_back({"great-stellated-dodecahedron", Mesh(spiked(Mesh(icosahedron()), golden))});
  all.push_back({"geodesic-sphere", Mesh(geodesic_sphere(3))});
  all.push_back({"quad-cube", Mesh(quad_cube(3))});
  all.push_back({"open-grid", Mesh(open_grid(3, 4))});
  return all;
}

inline Unfolding net_of(const Mesh& mesh) { return lay_flat(mesh, find_net(mesh).forest); }

}  // namespace plico::samples
