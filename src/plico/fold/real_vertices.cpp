#include "plico/fold/real_vertices.h"

#include <algorithm>
#include <map>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fold/linkage.h"

namespace plico {
namespace {

struct Crossing {
  int hinge;
  Vec2 from, direction;
};

// The borders of a sheet, one closed walk each, with the sheet on the left.
class Borders {
 public:
  Borders(const CreasePattern& sheet, const std::vector<int>& hinge) : sheet_(sheet), part_(parts_of(sheet)) {
    for (int f = 0; f < sheet.num_faces(); ++f)
      for (std::size_t i = 0; i < sheet.faces[f].size(); ++i)
        if (const Side side{sheet.faces[f][i], corner(f, i + 1)}; !side_.emplace(side, Place{f, i}).second)
          throw InvalidInput("fold/face-sides", fmt::format("panel {} lies on another one", f),
                             fmt::format("at the side from vertex {} to {}", side.first, side.second));
    for (int e = 0; e < sheet.num_edges(); ++e) hinge_[std::minmax(sheet.edges[e].a, sheet.edges[e].b)] = hinge[e];
  }

  struct Border {
    double area = 0;  // signed, positive for the outer border
    int part = -1, lowest = -1;
    std::vector<Crossing> crossings;  // counter-clockwise as seen from inside a hole
  };

  std::vector<Border> run() {
    std::vector<Border> borders;
    std::map<std::pair<int, int>, bool> seen;
    for (const auto& [ends, place] : side_) {
      if (!is_border(ends) || seen[ends]) continue;
      borders.push_back(follow(ends, seen));
    }
    return borders;
  }

 private:
  using Side = std::pair<int, int>;           // vertices, in the direction in which the panel on its left has them
  using Place = std::pair<int, std::size_t>;  // panel and index

  int corner(int face, std::size_t i) const { return sheet_.faces[face][i % sheet_.faces[face].size()]; }
  Side after(const Side& side) const {
    const auto [face, i] = side_.at(side);
    return {side.second, corner(face, i + 2)};
  }
  bool is_border(const Side& side) const {
    const auto at = hinge_.find(std::minmax(side.first, side.second));
    return at == hinge_.end() || at->second < 0;
  }

  Border follow(const Side& start, std::map<Side, bool>& seen) const {
    Border border;
    border.part = part_[side_.at(start).first];
    Side at = start;
    do {
      seen[at] = true;
      const Vec2 &p = sheet_.vertices[at.first], &q = sheet_.vertices[at.second];
      border.area += cross(p - sheet_.vertices[start.first], q - p) / 2;
      border.lowest = border.lowest < 0 ? at.first : std::min(border.lowest, at.first);
      for (at = after(at); !is_border(at); at = after({at.second, at.first})) {
        const int h = hinge_.at(std::minmax(at.first, at.second));
        const Vec2& from = sheet_.vertices[at.first];
        border.crossings.push_back({h, from, (sheet_.vertices[at.second] - from).normalized()});
      }
    } while (at != start);
    std::reverse(border.crossings.begin(), border.crossings.end());
    return border;
  }

  const CreasePattern& sheet_;
  std::vector<int> part_;
  std::map<Side, Place> side_;
  std::map<Side, int> hinge_;
};

RealVertex around(const CreasePattern& sheet, const Borders::Border& border, double scale) {
  RealVertex hole;
  hole.vertex = border.lowest;
  hole.place = sheet.vertices[border.lowest];
  for (const Crossing& crossing : border.crossings) {
    hole.hinges.push_back(crossing.hinge);
    hole.directions.push_back(crossing.direction);
    hole.points.emplace_back((crossing.from - border.crossings.front().from) / scale);
  }
  return hole;
}

void add_holes(const CreasePattern& sheet, const std::vector<int>& hinge, std::vector<RealVertex>& result) {
  const std::vector<Borders::Border> borders = Borders(sheet, hinge).run();
  std::map<int, double> outer;
  for (const auto& border : borders) outer[border.part] = std::max(outer[border.part], border.area);
  const double scale = diagonal(sheet);
  for (const auto& border : borders)
    if (border.area < outer[border.part] && !border.crossings.empty()) result.push_back(around(sheet, border, scale));
}

}  // namespace

std::vector<RealVertex> real_vertices(const CreasePattern& sheet) {
  const std::vector<int> hinge = hinge_of_edge(sheet);
  std::vector<std::vector<int>> edges(sheet.vertices.size());
  for (int e = 0; e < sheet.num_edges(); ++e) {
    edges[sheet.edges[e].a].push_back(e);
    edges[sheet.edges[e].b].push_back(e);
  }
  const auto direction = [&](int e, int v) -> Vec2 {
    const int other = sheet.edges[e].a == v ? sheet.edges[e].b : sheet.edges[e].a;
    return (sheet.vertices[other] - sheet.vertices[v]).normalized();
  };
  std::vector<RealVertex> result;
  for (int v = 0; v < sheet.num_vertices(); ++v) {
    std::vector<int>& spokes = edges[v];
    if (spokes.empty() || std::any_of(spokes.begin(), spokes.end(), [&](int e) { return hinge[e] < 0; })) continue;
    const auto turn = [&](int e) { return plico::atan2(direction(e, v).y(), direction(e, v).x()); };
    std::sort(spokes.begin(), spokes.end(), [&](int e, int f) { return turn(e) < turn(f); });
    RealVertex& vertex = result.emplace_back();
    vertex.vertex = v;
    vertex.place = sheet.vertices[v];
    for (int e : spokes) {
      vertex.hinges.push_back(hinge[e]);
      vertex.directions.push_back(direction(e, v));
    }
  }
  add_holes(sheet, hinge, result);
  return result;
}

double diagonal(const CreasePattern& sheet) {
  if (sheet.vertices.empty()) return 0;
  Vec2 low = sheet.vertices.front(), high = low;
  for (const Vec2& p : sheet.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

}  // namespace plico
