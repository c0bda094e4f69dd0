#include "plico/fold/linkage.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "plico/base/error.h"

namespace plico {
namespace {

struct Arc {
  int panel, hinge;
};

std::vector<std::vector<Arc>> panel_graph(const Linkage& linkage) {
  std::vector<std::vector<Arc>> graph(linkage.panels.size());
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    graph[linkage.hinges[h].left].push_back({linkage.hinges[h].right, h});
    graph[linkage.hinges[h].right].push_back({linkage.hinges[h].left, h});
  }
  return graph;
}

// Panels in breadth-first order from `root`; fills parents.
std::vector<int> breadth_first(const std::vector<std::vector<Arc>>& graph, int root, std::vector<int>& parent_panel,
                               std::vector<int>& parent_hinge, std::vector<int>& seen, int mark) {
  std::vector<int> order{root};
  seen[root] = mark;
  parent_panel[root] = parent_hinge[root] = -1;
  for (std::size_t at = 0; at < order.size(); ++at) {
    for (const Arc& arc : graph[order[at]]) {
      if (seen[arc.panel] == mark) continue;
      seen[arc.panel] = mark;
      parent_panel[arc.panel] = order[at];
      parent_hinge[arc.panel] = arc.hinge;
      order.push_back(arc.panel);
    }
  }
  return order;
}

// The middle of a longest shortest path of the part that holds `panel`: exact for trees, a good middle for loops.
int middle_of(const std::vector<std::vector<Arc>>& graph, int panel, std::vector<int>& seen, int& mark) {
  std::vector<int> parent(graph.size(), -1), hinge(graph.size(), -1);
  const int far = breadth_first(graph, panel, parent, hinge, seen, ++mark).back();
  std::vector<int> path;
  for (int p = breadth_first(graph, far, parent, hinge, seen, ++mark).back(); p >= 0; p = parent[p]) path.push_back(p);
  return path[path.size() / 2];
}

void grow_trees(Linkage& linkage, int base) {
  const auto graph = panel_graph(linkage);
  const int n = linkage.num_panels();
  linkage.parent_panel.assign(n, -1);
  linkage.parent_hinge.assign(n, -1);
  std::vector<int> seen(n, 0), scratch(n, 0);
  int mark = 0;
  const auto grow = [&](int root) {
    const auto part = breadth_first(graph, root, linkage.parent_panel, linkage.parent_hinge, seen, 1);
    linkage.order.insert(linkage.order.end(), part.begin(), part.end());
  };
  if (base >= 0) grow(base);
  for (int p = 0; p < n; ++p)
    if (!seen[p]) grow(middle_of(graph, p, scratch, mark));
  std::vector<char> in_tree(linkage.hinges.size(), 0);
  for (int h : linkage.parent_hinge)
    if (h >= 0) in_tree[h] = 1;
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (!in_tree[h]) linkage.loop_hinges.push_back(h);
}

// The panel and side of every directed edge of the sheet.
std::map<std::pair<int, int>, std::pair<int, int>> side_table(const CreasePattern& sheet) {
  std::map<std::pair<int, int>, std::pair<int, int>> table;
  for (int f = 0; f < sheet.num_faces(); ++f) {
    const std::vector<int>& face = sheet.faces[f];
    for (int i = 0; i < static_cast<int>(face.size()); ++i) table[{face[i], face[(i + 1) % face.size()]}] = {f, i};
  }
  return table;
}

void add_seams(Linkage& linkage, const CreasePattern& sheet, const std::vector<int>& mate) {
  if (mate.empty()) return;
  const auto sides = side_table(sheet);
  const auto find = [&](int e) {
    const auto at = sides.find({sheet.edges[e].a, sheet.edges[e].b});
    return at != sides.end() ? at->second : sides.at({sheet.edges[e].b, sheet.edges[e].a});
  };
  for (int e = 0; e < sheet.num_edges(); ++e) {
    if (mate[e] <= e) continue;
    const auto [panel_a, side_a] = find(e);
    const auto [panel_b, side_b] = find(mate[e]);
    linkage.seams.push_back({panel_a, side_a, panel_b, side_b});
  }
}

}  // namespace

Linkage make_linkage(const CreasePattern& sheet, const std::vector<int>& mate, int base) {
  Linkage linkage;
  const auto lift = [&](int v) { return Vec3(sheet.vertices[v].x(), sheet.vertices[v].y(), 0); };
  for (const std::vector<int>& face : sheet.faces) {
    std::vector<Vec3>& outline = linkage.panels.emplace_back();
    for (int v : face) outline.push_back(lift(v));
  }
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e) {
    const Crease& crease = sheet.edges[e];
    if (!is_hinge(crease, sides[e])) continue;
    linkage.hinges.push_back({sides[e].left, sides[e].right, lift(crease.a), lift(crease.b), crease.fold_angle,
                              -crease.limit, crease.limit, 0, e, crease.a, crease.b});
  }
  grow_trees(linkage, base);
  if (linkage.has_loops()) linkage.loops = real_vertices(sheet);
  add_seams(linkage, sheet, mate);
  return linkage;
}

Linkage thickened(Linkage linkage, double thickness, const std::vector<double>& offset) {
  require(thickness >= 0 && std::isfinite(thickness), "thickness", thickness, "a finite length, at least 0");
  if (!offset.empty() && offset.size() != linkage.hinges.size())
    throw InvalidOption(fmt::format("{} offsets for {} hinges", offset.size(), linkage.hinges.size()));
  linkage.thickness = thickness;
  for (std::size_t h = 0; h < linkage.hinges.size(); ++h) {
    const double z = offset.empty() ? 0 : offset[h];
    if (!(std::abs(z) <= thickness / 2))
      throw InvalidOption(
          fmt::format("offset {} of hinge {} must be in [-{}, {}]", z, h, thickness / 2, thickness / 2));
    linkage.hinges[h].from.z() = linkage.hinges[h].to.z() = z;
  }
  return linkage;
}

Linkage thick_hinged(Linkage linkage, double thickness, double trim) {
  for (std::vector<Vec3>& outline : linkage.panels) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& corner : outline) centre += corner / static_cast<double>(outline.size());
    const double half = (outline[1] - outline[0]).norm() / 2;
    require(thickness > 0 && thickness < half, "thickness", thickness,
            fmt::format("above 0 and below half a panel's side, {:.6g}", half));
    require(trim >= thickness / 2 && trim < half, "trim", trim,
            fmt::format("in [thickness / 2, side / 2) = [{:.6g}, {:.6g})", thickness / 2, half));
    for (Vec3& corner : outline) corner = centre + (1 - trim / half) * (corner - centre);
  }
  linkage.thickness = thickness;
  for (Hinge& hinge : linkage.hinges) hinge.roll = thickness / 2;
  return linkage;
}

std::vector<int> hinge_of_edge(const CreasePattern& sheet) {
  std::vector<int> hinge;
  int next = 0;
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e) hinge.push_back(is_hinge(sheet.edges[e], sides[e]) ? next++ : -1);
  return hinge;
}

Configuration flat(const Linkage& linkage) { return Configuration::Zero(linkage.num_hinges()); }

Configuration goal(const Linkage& linkage) {
  Configuration config(linkage.num_hinges());
  for (int h = 0; h < linkage.num_hinges(); ++h) config[h] = linkage.hinges[h].target;
  return config;
}

double share_of_way(const Linkage& linkage, const Configuration& config) {
  double whole = 0, rest = 0;
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    const double target = linkage.hinges[h].target;
    if (target == 0) continue;
    whole += target * target;
    rest += (target - config[h]) * (target - config[h]);
  }
  return whole > 0 ? 1 - std::sqrt(rest / whole) : 1;
}

Configuration lower_limits(const Linkage& linkage) {
  Configuration limits(linkage.num_hinges());
  for (int h = 0; h < linkage.num_hinges(); ++h) limits[h] = linkage.hinges[h].low;
  return limits;
}

Configuration upper_limits(const Linkage& linkage) {
  Configuration limits(linkage.num_hinges());
  for (int h = 0; h < linkage.num_hinges(); ++h) limits[h] = linkage.hinges[h].high;
  return limits;
}

int hinge_beyond_limits(const Linkage& linkage, const Configuration& config, double slack) {
  PLICO_ASSERT(config.size() == linkage.num_hinges());
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (config[h] < linkage.hinges[h].low - slack || config[h] > linkage.hinges[h].high + slack) return h;
  return -1;
}

void require_within_limits(const Linkage& linkage, const Configuration& config, std::string_view what, double slack) {
  const int h = hinge_beyond_limits(linkage, config, slack);
  if (h < 0) return;
  const Hinge& hinge = linkage.hinges[h];
  throw InvalidInput("fold/limits", fmt::format("{} folds panels {} and {} by {:.4g} degrees, the limit is {:.4g}",
                                                what, hinge.left, hinge.right, degrees(std::abs(config[h])),
                                                degrees(std::abs(config[h] > hinge.high ? hinge.high : hinge.low))));
}

std::string tell_hinge(const Linkage& linkage, int hinge) {
  const Hinge& h = linkage.hinges[hinge];
  if (h.edge < 0) return fmt::format("hinge {} (panels {}-{})", hinge, h.left, h.right);
  const Vec3 middle = (h.from + h.to) / 2;
  return fmt::format("crease {} (vertices {}-{}, near {:.6g} {:.6g})", h.edge, h.a, h.b, middle.x(), middle.y());
}

std::string tell_vertex(const Linkage& linkage, int vertex) {
  const auto at = std::find_if(linkage.loops.begin(), linkage.loops.end(),
                               [&](const RealVertex& loop) { return loop.vertex == vertex; });
  if (at == linkage.loops.end()) return "no vertex";
  return fmt::format("vertex {} ({:.6g}, {:.6g})", vertex, at->place.x(), at->place.y());
}

Pose turn(const Hinge& hinge, double fold_angle, bool right_moves) {
  const Vec3 axis = (hinge.to - hinge.from).normalized();
  // Turning the right panel up (a valley) is a left-handed turn about from -> to.
  const double angle = right_moves ? -fold_angle : fold_angle;
  if (hinge.roll == 0 || std::abs(angle) <= kPi / 2) return rotation_about(hinge.from, axis, angle);
  const double quarter = std::copysign(kPi / 2, angle);
  const Vec3 left(-axis.y(), axis.x(), 0);
  const Vec3 before = right_moves ? left : Vec3(-left);
  const Vec3 contact = hinge.from + hinge.roll * (before + std::copysign(1.0, fold_angle) * Vec3::UnitZ());
  return rotation_about(contact, axis, angle - quarter) * rotation_about(hinge.from, axis, quarter);
}

std::vector<Pose> folding_map(const Linkage& linkage, const Configuration& config) {
  std::vector<Pose> poses;
  folding_map(linkage, config, poses);
  return poses;
}

void folding_map(const Linkage& linkage, const Configuration& config, std::vector<Pose>& poses) {
  PLICO_ASSERT(config.size() == linkage.num_hinges());
  poses.resize(linkage.panels.size());
  for (int p : linkage.order) {
    const int h = linkage.parent_hinge[p];
    if (h < 0) {
      poses[p].setIdentity();
      continue;
    }
    poses[p] = poses[linkage.parent_panel[p]] * turn(linkage.hinges[h], config[h], p == linkage.hinges[h].right);
  }
}

std::vector<int> parts(const Linkage& linkage) {
  std::vector<int> part(linkage.panels.size(), -1);
  int count = 0;
  for (int p : linkage.order) part[p] = linkage.parent_panel[p] < 0 ? count++ : part[linkage.parent_panel[p]];
  return part;
}

double mean_side_length(const Linkage& linkage) {
  double sum = 0;
  long count = 0;
  for (const std::vector<Vec3>& outline : linkage.panels) {
    for (std::size_t i = 0; i < outline.size(); ++i) sum += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    count += static_cast<long>(outline.size());
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

double default_clearance(const Linkage& linkage) { return 1e-3 * mean_side_length(linkage); }

int chain_depth(const Linkage& linkage) {
  std::vector<int> depth(linkage.panels.size(), 0);
  int deepest = 0;
  for (int p : linkage.order)
    if (linkage.parent_panel[p] >= 0) deepest = std::max(deepest, depth[p] = depth[linkage.parent_panel[p]] + 1);
  return deepest;
}

}  // namespace plico
