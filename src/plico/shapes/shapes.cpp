#include "plico/shapes/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kGolden = std::numbers::phi;

using Points = std::vector<Vec3>;

void require(const char* what, int value, int low, int high) {
  if (value < low || value > high)
    throw InvalidOption(fmt::format("{} = {} must be in [{}, {}]", what, value, low, high));
}

// All signs of (x, y, z), each point once.
Points signs(double x, double y, double z) {
  Points points;
  for (int s = 0; s < 8; ++s) {
    const Vec3 p(s & 1 ? -x : x, s & 2 ? -y : y, s & 4 ? -z : z);
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

// All signs of the three cyclic turns of (x, y, z).
Points cyclic_signs(double x, double y, double z) {
  Points points;
  for (const Vec3& turn : {Vec3(x, y, z), Vec3(z, x, y), Vec3(y, z, x)})
    for (const Vec3& p : signs(turn.x(), turn.y(), turn.z())) points.push_back(p);
  return points;
}

Points joined(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Counter-clockwise seen from the tip of `axis`.
void sort_around(const Vec3& axis, const Points& points, std::vector<int>& corners) {
  const Vec3 n = axis.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  const auto angle = [&](int i) { return plico::atan2(points[i].dot(v), points[i].dot(u)); };
  std::sort(corners.begin(), corners.end(), [&](int a, int b) { return angle(a) < angle(b); });
}

// The convex solid with these corners that has one face across each of `directions`; scaled to the unit sphere.
PolygonSoup convex_solid(Points points, const Points& directions) {
  for (Vec3& p : points) p.normalize();
  PolygonSoup solid;
  for (const Vec3& d : directions) {
    double top = 0;
    for (const Vec3& p : points) top = std::max(top, d.dot(p));
    std::vector<int> corners;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      if (d.dot(points[i]) > top - 1e-9) corners.push_back(i);
    sort_around(d, points, corners);
    solid.add_face(corners);
  }
  solid.points = std::move(points);
  return solid;
}

void require_closed(const Mesh& mesh) {
  for (EdgeId e : mesh.edges())
    if (mesh.is_boundary(e)) throw InvalidInput("shape/open", "the solid to be cut is not closed");
}

// One polygon per corner of the solid, through the points numbered by `point_of` for the halfedges that leave it.
template <class PointOf>
void add_corner_faces(const Mesh& solid, PolygonSoup& cut, PointOf point_of) {
  for (VertexId v : solid.vertices()) {
    std::vector<int> corners;
    HalfedgeId h = solid.halfedge(v);
    do {
      corners.push_back(point_of(h));
      h = solid.twin(solid.prev(h));
    } while (h != solid.halfedge(v));
    cut.add_face(corners);
  }
}

// The number of the point at a place of a lattice, made when first asked for.
class PointIndex {
 public:
  explicit PointIndex(Points& points) : points_(points) {}
  int operator()(const Vec3& p) {
    constexpr double kGrain = 1e7;  // lattice points are farther apart and meet within rounding
    const Key key{std::llround(p.x() * kGrain), std::llround(p.y() * kGrain), std::llround(p.z() * kGrain)};
    const auto [at, is_new] = index_.try_emplace(key, static_cast<int>(points_.size()));
    if (is_new) points_.push_back(p);
    return at->second;
  }

 private:
  using Key = std::array<long long, 3>;
  Points& points_;
  std::map<Key, int> index_;
};

PolygonSoup two_rings(int n, double lower_turn, double height) {
  PolygonSoup soup;
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n + (ring == 0 ? lower_turn : 0);
      soup.points.emplace_back(plico::cos(angle), plico::sin(angle), (ring - 0.5) * height);
    }
  }
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  soup.add_face(bottom);
  soup.add_face(top);
  return soup;
}

}  // namespace

PolygonSoup tetrahedron() {
  const Points points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  Points opposite = points;
  for (Vec3& d : opposite) d = -d;
  return convex_solid(points, opposite);
}

PolygonSoup cube() { return convex_solid(signs(1, 1, 1), cyclic_signs(1, 0, 0)); }
PolygonSoup octahedron() { return convex_solid(cyclic_signs(1, 0, 0), signs(1, 1, 1)); }

PolygonSoup dodecahedron() {
  return convex_solid(joined(signs(1, 1, 1), cyclic_signs(0, kGolden, 1 / kGolden)), cyclic_signs(0, 1, kGolden));
}

PolygonSoup icosahedron() {
  return convex_solid(cyclic_signs(0, 1, kGolden), joined(signs(1, 1, 1), cyclic_signs(0, kGolden, 1 / kGolden)));
}

PolygonSoup truncated(const Mesh& solid, int degree) {
  require("degree", degree, 3, 1'000'000);
  require_closed(solid);
  const double t = 1 / (2 + 2 * plico::cos(kPi / degree));
  PolygonSoup cut;
  for (HalfedgeId h : IdRange<HalfedgeId>(solid.num_halfedges())) {
    const Vec3 &a = solid.point(solid.from(h)), &b = solid.point(solid.to(h));
    cut.points.emplace_back(a + t * (b - a));
  }
  for (FaceId f : solid.faces()) {
    std::vector<int> corners;
    for (HalfedgeId h : solid.halfedges(f)) corners.insert(corners.end(), {h, solid.twin(h)});
    cut.add_face(corners);
  }
  add_corner_faces(solid, cut, [](HalfedgeId h) { return h.value; });
  return cut;
}

PolygonSoup rectified(const Mesh& solid) {
  require_closed(solid);
  PolygonSoup cut;
  for (EdgeId e : solid.edges()) {
    const HalfedgeId h = solid.halfedge(e);
    cut.points.emplace_back((solid.point(solid.from(h)) + solid.point(solid.to(h))) / 2);
  }
  for (FaceId f : solid.faces()) {
    std::vector<int> corners;
    for (HalfedgeId h : solid.halfedges(f)) corners.push_back(solid.edge(h));
    cut.add_face(corners);
  }
  add_corner_faces(solid, cut, [&](HalfedgeId h) { return solid.edge(h).value; });
  return cut;
}

PolygonSoup spiked(const Mesh& solid, double leg) {
  require_closed(solid);
  PolygonSoup star;
  star.points = solid.soup().points;
  for (FaceId f : solid.faces()) {
    const HalfedgeId first = *solid.halfedges(f).begin();
    const double side = length(solid, solid.edge(first));
    const double radius = (solid.point(solid.from(first)) - center(solid, f)).norm();
    if (!(leg * side > radius && std::isfinite(leg)))
      throw InvalidOption(fmt::format("leg = {} must be above {} to make a spike", leg, radius / side));
    const int tip = star.num_points();
    star.points.emplace_back(center(solid, f) +
                             std::sqrt(leg * leg * side * side - radius * radius) * normal(solid, f));
    for (HalfedgeId h : solid.halfedges(f)) star.add_face({solid.from(h), solid.to(h), tip});
  }
  return star;
}

PolygonSoup prism(int n) {
  require("n", n, 3, 1'000'000);
  PolygonSoup soup = two_rings(n, 0, 2 * plico::sin(kPi / n));
  for (int i = 0; i < n; ++i) soup.add_face({i, (i + 1) % n, n + (i + 1) % n, n + i});
  return soup;
}

PolygonSoup frustum(int n, double top, double height) {
  require("n", n, 3, 1'000'000);
  PolygonSoup soup;
  const auto ring = [&](double radius, double y) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * (i + 0.5) / n;  // a side, not a corner, looks along x
      soup.points.emplace_back(radius * plico::cos(angle), y, -radius * plico::sin(angle));
    }
  };
  ring(1, 0);
  std::vector<int> bottom, lid;
  for (int i = 0; i < n; ++i) bottom.push_back(n - 1 - i), lid.push_back(n + i);
  soup.add_face(bottom);
  if (top > 0) {
    ring(top, height);
    soup.add_face(lid);
  } else {
    soup.points.emplace_back(0, height, 0);
  }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    if (top > 0)
      soup.add_face({i, next, n + next, n + i});
    else
      soup.add_face({i, next, n});
  }
  return soup;
}

PolygonSoup house() {
  PolygonSoup soup;
  for (double z : {1.5, -1.5})
    for (const Vec2& p : {Vec2(-1, 0), Vec2(1, 0), Vec2(1, 1.4), Vec2(0, 2.4), Vec2(-1, 1.4)})
      soup.points.emplace_back(p.x(), p.y(), z);
  soup.add_face({0, 1, 2, 3, 4});
  soup.add_face({9, 8, 7, 6, 5});
  for (int i = 0; i < 5; ++i) soup.add_face({(i + 1) % 5, i, 5 + i, 5 + (i + 1) % 5});
  return soup;
}

PolygonSoup antiprism(int n) {
  require("n", n, 3, 1'000'000);
  const double side = 2 * plico::sin(kPi / n), shift = 2 * plico::sin(kPi / (2 * n));
  PolygonSoup soup = two_rings(n, kPi / n, std::sqrt(side * side - shift * shift));
  for (int i = 0; i < n; ++i) {
    soup.add_face({i, n + (i + 1) % n, n + i});
    soup.add_face({i, (i + 1) % n, n + (i + 1) % n});
  }
  return soup;
}

PolygonSoup geodesic_sphere(int frequency) {
  require("frequency", frequency, 1, 1000);
  const PolygonSoup base = icosahedron();
  PolygonSoup sphere;
  PointIndex index(sphere.points);
  for (int f = 0; f < base.num_faces(); ++f) {
    const Vec3 &a = base.points[base.face(f)[0]], &b = base.points[base.face(f)[1]], &c = base.points[base.face(f)[2]];
    const auto at = [&](int i, int j) { return index(((frequency - i - j) * a + i * b + j * c) / frequency); };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        sphere.add_face({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < frequency) sphere.add_face({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  for (Vec3& p : sphere.points) p.normalize();
  return sphere;
}

PolygonSoup torus(int n, int m, double tube) {
  require("n", n, 3, 1'000'000);
  require("m", m, 3, 1'000'000);
  require(tube > 0 && tube < 1, "tube", tube, "in (0, 1)");
  PolygonSoup soup;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double around = 2 * kPi * i / n, up = 2 * kPi * j / m, r = 1 + tube * plico::cos(up);
      soup.points.emplace_back(r * plico::cos(around), r * plico::sin(around), tube * plico::sin(up));
    }
  }
  const auto at = [&](int i, int j) { return (i % n) * m + j % m; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) soup.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return soup;
}

PolygonSoup quad_cube(int n) {
  require("n", n, 1, 1000);
  const PolygonSoup base = cube();
  PolygonSoup soup;
  PointIndex index(soup.points);
  for (int f = 0; f < base.num_faces(); ++f) {
    const Vec3 &a = base.points[base.face(f)[0]], &b = base.points[base.face(f)[1]], &d = base.points[base.face(f)[3]];
    const auto at = [&](int i, int j) { return index(a + (i * (b - a) + j * (d - a)) / n); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) soup.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return soup;
}

PolygonSoup open_grid(int n, int m) {
  require("n", n, 1, 10'000);
  require("m", m, 1, 10'000);
  PolygonSoup soup;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) soup.points.emplace_back(i, j, 0);
  const auto at = [&](int i, int j) { return i * (m + 1) + j; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) soup.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return soup;
}

}  // namespace plico
