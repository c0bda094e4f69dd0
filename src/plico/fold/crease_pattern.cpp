#include "plico/fold/crease_pattern.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "plico/base/error.h"

namespace plico {
namespace {

// A directed side of a panel; the key orders sides by their vertices.
struct PanelSide {
  std::uint64_t key;
  int panel;
  auto operator<=>(const PanelSide&) const = default;
};

std::uint64_t side_key(int a, int b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b); }

std::vector<PanelSide> sorted_sides(const CreasePattern& pattern) {
  std::vector<PanelSide> sides;
  for (int f = 0; f < pattern.num_faces(); ++f) {
    const std::vector<int>& face = pattern.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) sides.push_back({side_key(face[i], face[(i + 1) % face.size()]), f});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::vector<EdgeSides> edge_sides(const CreasePattern& pattern) {
  const std::vector<PanelSide> sides = sorted_sides(pattern);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1].key != sides[i].key) continue;
    const int a = static_cast<int>(sides[i].key >> 32), b = static_cast<int>(sides[i].key & 0xffffffffu);
    throw InvalidInput(
        "fold/side-used-twice",
        fmt::format("panels {} and {} lie on the same side of {}-{}", sides[i - 1].panel, sides[i].panel, a, b),
        fmt::format("near {:.6g} {:.6g}", pattern.vertices[a].x(), pattern.vertices[a].y()));
  }
  const auto find = [&](int a, int b) {
    const PanelSide wanted{side_key(a, b), -1};
    const auto at = std::lower_bound(sides.begin(), sides.end(), wanted);
    return at == sides.end() || at->key != wanted.key ? -1 : at->panel;
  };
  std::vector<EdgeSides> result;
  result.reserve(pattern.edges.size());
  for (const Crease& e : pattern.edges) result.push_back({find(e.a, e.b), find(e.b, e.a)});
  return result;
}

std::vector<int> parts_of(const CreasePattern& pattern) {
  std::vector<int> root(pattern.faces.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int p) {
    while (root[p] != p) p = root[p] = root[root[p]];
    return p;
  };
  for (const EdgeSides& sides : edge_sides(pattern)) {
    if (sides.left < 0 || sides.right < 0) continue;
    const int a = find(sides.left), b = find(sides.right);
    root[std::max(a, b)] = std::min(a, b);  // the root of a piece is its first panel
  }
  std::vector<int> part(pattern.faces.size());
  int parts = 0;
  for (int f = 0; f < pattern.num_faces(); ++f) part[f] = find(f) == f ? parts++ : part[find(f)];
  return part;
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

double flat_fold_angle(Assignment assignment) {
  if (assignment == Assignment::Mountain) return -kPi;
  return assignment == Assignment::Valley ? kPi : 0;
}

bool is_hinge(const Crease& edge, const EdgeSides& sides) {
  return sides.left >= 0 && sides.right >= 0 && edge.assignment != Assignment::Boundary &&
         edge.assignment != Assignment::Cut;
}

}  // namespace plico
