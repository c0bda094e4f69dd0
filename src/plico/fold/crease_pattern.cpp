#include "plico/fold/crease_pattern.h"

#include <algorithm>
#include <map>

#include "plico/base/error.h"

namespace plico {

std::vector<EdgeSides> edge_sides(const CreasePattern& pattern) {
  std::map<std::pair<int, int>, int> panel_along;  // directed side -> the panel on its left
  for (int f = 0; f < pattern.num_faces(); ++f) {
    const std::vector<int>& face = pattern.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::pair<int, int> side{face[i], face[(i + 1) % face.size()]};
      const auto [at, added] = panel_along.emplace(side, f);
      if (!added)
        throw InvalidInput(
            "fold/side-used-twice",
            fmt::format("panels {} and {} lie on the same side of {}-{}", at->second, f, side.first, side.second),
            fmt::format("near {:.6g} {:.6g}", pattern.vertices[side.first].x(), pattern.vertices[side.first].y()));
    }
  }
  const auto find = [&](int a, int b) {
    const auto at = panel_along.find({a, b});
    return at == panel_along.end() ? -1 : at->second;
  };
  std::vector<EdgeSides> sides;
  sides.reserve(pattern.edges.size());
  for (const Crease& e : pattern.edges) sides.push_back({find(e.a, e.b), find(e.b, e.a)});
  return sides;
}

std::vector<Vec2> polygon(const CreasePattern& pattern, int face) {
  std::vector<Vec2> corners;
  corners.reserve(pattern.faces[face].size());
  for (int v : pattern.faces[face]) corners.push_back(pattern.vertices[v]);
  return corners;
}

Assignment assignment_of(double fold_angle, double flat) {
  if (std::abs(fold_angle) <= flat) return Assignment::Flat;
  return fold_angle > 0 ? Assignment::Valley : Assignment::Mountain;
}

}  // namespace plico
