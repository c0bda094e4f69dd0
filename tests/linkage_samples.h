// Small linkages for tests.
#pragma once
#include <vector>

#include "plico/base/rng.h"
#include "plico/fold/folding_path.h"
#include "plico/geom/polygon.h"

namespace plico {

// Unit squares in a row along +x; hinge i, between squares i and i + 1, has target angles[i].
inline CreasePattern square_strip(const std::vector<double>& angles) {
  CreasePattern sheet;
  const int squares = static_cast<int>(angles.size()) + 1;
  for (int i = 0; i <= squares; ++i) {
    sheet.vertices.emplace_back(i, 0);
    sheet.vertices.emplace_back(i, 1);
  }
  for (int i = 0; i < squares; ++i) sheet.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  for (int i = 1; i < squares; ++i)
    sheet.edges.push_back({2 * i, 2 * i + 1, assignment_of(angles[i - 1]), angles[i - 1]});
  return sheet;
}

// `panels` equilateral triangles that do not overlap, grown at random, with random targets in [-most, most].
inline CreasePattern random_triangles(int panels, double most, Rng& rng) {
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {1, 0}, {0.5, 0.8660254037844386}};
  sheet.faces = {{0, 1, 2}};
  while (sheet.num_faces() < panels) {
    const std::vector<int> face = sheet.faces[rng.below(sheet.num_faces())];
    const int side = rng.below(3), a = face[side], b = face[(side + 1) % 3];
    const Vec2 p = sheet.vertices[a], q = sheet.vertices[b];
    const Vec2 apex = (p + q) / 2 - 0.8660254037844386 * perpendicular(q - p);
    const std::vector<Vec2> grown{q, p, apex};
    bool free = true;
    for (int f = 0; f < sheet.num_faces() && free; ++f) {
      const std::vector<Vec2> other = polygon(sheet, f);
      free =
          (centroid(other) - centroid(grown)).norm() > 0.1;  // on the triangular lattice, cells are equal or disjoint
    }
    if (!free) continue;
    sheet.faces.push_back({b, a, sheet.num_vertices()});
    sheet.vertices.push_back(apex);
    const double angle = rng.uniform(-most, most);
    sheet.edges.push_back({a, b, assignment_of(angle), angle});
  }
  return sheet;
}

inline FoldingPath path_through(const std::vector<std::pair<double, std::vector<double>>>& waypoints) {
  FoldingPath path;
  for (const auto& [time, angles] : waypoints)
    path.waypoints.push_back({time, Eigen::Map<const Configuration>(angles.data(), static_cast<int>(angles.size()))});
  return path;
}

// The vertices of the sheet at its goal, in the frame of panel 0.
inline std::vector<Vec3> folded_vertices(const CreasePattern& sheet) {
  const Linkage linkage = make_linkage(sheet);
  const std::vector<Pose> poses = folding_map(linkage, goal(linkage));
  std::vector<Vec3> folded(sheet.vertices.size());
  for (int f = 0; f < sheet.num_faces(); ++f)
    for (int v : sheet.faces[f]) folded[v] = poses[f] * Vec3(sheet.vertices[v].x(), sheet.vertices[v].y(), 0);
  return folded;
}

}  // namespace plico
