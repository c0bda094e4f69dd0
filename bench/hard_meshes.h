// Closed meshes of our own that are hard to unfold, each in a way that scanned and designed ones are: a car body of
// thin sheet with windows (nearly flat everywhere, and twice), a bust with hair (strongly curved everywhere), an egg
// crate bent to a ring (every second vertex a saddle).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plico/mesh/soup.h"
#include "plico/shapes/named_shapes.h"

namespace plico::bench {

// The cells of a grid that are there, cut into triangles.
struct CellGrid {
  int rows, columns;
  std::vector<char> there;

  bool has(int i, int j) const { return i >= 0 && j >= 0 && i < rows && j < columns && there[i * columns + j] != 0; }
};

// Two triangles a, b, c, d, cut along b-d or else along a-c.
inline void add_quad(PolygonSoup& soup, int a, int b, int c, int d, bool other_diagonal) {
  if (other_diagonal) {
    soup.add_face(std::array{a, b, d});
    soup.add_face(std::array{b, c, d});
  } else {
    soup.add_face(std::array{a, b, c});
    soup.add_face(std::array{a, c, d});
  }
}

// A sheet with a thickness: the cells outside, once more inside, and a wall along every border.
inline PolygonSoup thick_sheet(const CellGrid& grid, const auto& outside, const auto& inside) {
  PolygonSoup soup;
  std::vector<int> number((grid.rows + 1) * (grid.columns + 1), -1);
  for (int i = 0; i <= grid.rows; ++i) {
    for (int j = 0; j <= grid.columns; ++j) {
      if (!grid.has(i, j) && !grid.has(i - 1, j) && !grid.has(i, j - 1) && !grid.has(i - 1, j - 1)) continue;
      number[i * (grid.columns + 1) + j] = static_cast<int>(soup.points.size());
      soup.points.push_back(outside(i, j));
      soup.points.push_back(inside(i, j));
    }
  }
  const auto outer = [&](int i, int j) { return number[i * (grid.columns + 1) + j]; };
  const auto inner = [&](int i, int j) { return outer(i, j) + 1; };
  for (int i = 0; i < grid.rows; ++i) {
    for (int j = 0; j < grid.columns; ++j) {
      if (!grid.has(i, j)) continue;
      const bool other = (i + j) % 2 != 0;
      add_quad(soup, outer(i, j), outer(i + 1, j), outer(i + 1, j + 1), outer(i, j + 1), other);
      add_quad(soup, inner(i, j), inner(i, j + 1), inner(i + 1, j + 1), inner(i + 1, j), !other);
      const auto wall = [&](int i0, int j0, int i1, int j1) {
        add_quad(soup, outer(i1, j1), outer(i0, j0), inner(i0, j0), inner(i1, j1), other);
      };
      if (!grid.has(i, j - 1)) wall(i, j, i + 1, j);
      if (!grid.has(i + 1, j)) wall(i + 1, j, i + 1, j + 1);
      if (!grid.has(i, j + 1)) wall(i + 1, j + 1, i, j + 1);
      if (!grid.has(i - 1, j)) wall(i, j + 1, i, j);
    }
  }
  return soup;
}

inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// About `faces` triangles. A vault over the length of a car, flat on its sides and its roof, with six windows.
inline PolygonSoup car_body(int faces) {
  CellGrid grid;
  grid.rows = std::max(12, static_cast<int>(std::sqrt(faces / 4.0 * 1.25)));
  grid.columns = std::max(12, static_cast<int>(faces / 4.0 * 1.08 / grid.rows));
  const auto within = [](double x, double low, double high) { return x > low && x < high; };
  for (int i = 0; i < grid.rows; ++i) {
    for (int j = 0; j < grid.columns; ++j) {
      const double x = (i + 0.5) / grid.rows, v = (j + 0.5) / grid.columns;
      const bool side = within(v, 0.2, 0.3) || within(v, 0.7, 0.8);
      const bool glass = side && (within(x, 0.36, 0.5) || within(x, 0.54, 0.68));
      const bool wheel = (within(v, 0, 0.1) || within(v, 0.9, 1)) && within(x, 0.14, 0.26);
      grid.there.push_back(!glass && !wheel);
    }
  }
  const auto point = [&](double inset) {
    return [&grid, inset](int i, int j) {
      const double x = static_cast<double>(i) / grid.rows, v = 3.14159265358979 * j / grid.columns;
      const double height = 0.5 + 0.45 * smooth_step(0.26, 0.38, x) - 0.35 * smooth_step(0.72, 0.84, x) - inset;
      const double width = 0.7 + 0.05 * std::sin(3.14159265358979 * x) - inset;
      // A rounded rectangle: |y|^5 + |z|^5 = 1.
      const double c = std::cos(v), s = std::sin(v);
      const double r = 1 / std::pow(std::pow(std::abs(c), 5) + std::pow(std::abs(s), 5), 0.2);
      return Vec3(4 * x, width * r * c, height * r * s);
    };
  };
  return thick_sheet(grid, point(0), point(0.02));
}

// About `faces` triangles: a head with strands that run down from the crown.
inline PolygonSoup bust(int faces) {
  PolygonSoup soup = make_shape("sphere", {.faces = faces});
  for (Vec3& p : soup.points) {
    const Vec3 d = p.normalized();
    const double around = std::atan2(d.y(), d.x());
    const double hair = smooth_step(-0.3, 0.5, d.z() - 0.6 * d.x());
    const double strands = std::sin(31 * around + 5 * d.z()) * std::sqrt(std::max(0.0, 1 - d.z() * d.z()));
    const double nose = std::exp(-40 * ((d - Vec3(0.98, 0, -0.2)).squaredNorm()));
    p = (1 + 0.06 * hair * (2 + strands + 0.3 * std::sin(90 * d.z() + 3 * strands)) + 0.2 * nose) * d;
    p.z() *= 1.3;
  }
  return soup;
}

// About `faces` triangles: dents and bumps in turn on a ring.
inline PolygonSoup egg_crate(int faces) {
  const int around = std::max(12, static_cast<int>(std::sqrt(faces / 2.0 * 2.5))),
            across = std::max(6, faces / 2 / around);
  PolygonSoup soup;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * 3.14159265358979 * i / around, v = 2 * 3.14159265358979 * j / across;
      const double r = 0.4 + 0.03 * std::sin(30 * u) * std::sin(12 * v);
      soup.points.emplace_back((1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u),
                               r * std::sin(v));
    }
  }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      add_quad(soup, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), (i + j) % 2 != 0);
  return soup;
}

}  // namespace plico::bench
