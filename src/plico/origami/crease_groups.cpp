#include "plico/origami/crease_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "plico/base/disjoint_sets.h"
#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

// In 1e-5 degrees; patterns have round angles, so the odd offset keeps them away from where rounding would split them.
long rounded(double angle) { return std::lround(degrees(angle) * 1e5 + 0.137); }

// One crease that moves, as the walk around its vertex meets it.
struct Spoke {
  int hinge;
  long sector;  // to the next one, counter-clockwise
  long goal;
};

std::vector<Spoke> spokes_of(const RealVertex& vertex, const Linkage& linkage) {
  std::vector<Spoke> spokes;
  std::vector<double> angles;
  for (std::size_t k = 0; k < vertex.hinges.size(); ++k) {
    const int h = vertex.hinges[k];
    if (linkage.hinges[h].target == 0) continue;
    spokes.push_back({h, 0, rounded(std::abs(linkage.hinges[h].target)) * (linkage.hinges[h].target > 0 ? 1 : -1)});
    angles.push_back(plico::atan2(vertex.directions[k].y(), vertex.directions[k].x()));
  }
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    double sector = angles[(k + 1) % angles.size()] - angles[k];
    while (sector <= 1e-9) sector += 2 * kPi;
    spokes[k].sector = rounded(sector);
  }
  return spokes;
}

// One of the ways to look at a vertex: from spoke `first` on, mirrored or not, turned over or not.
struct View {
  std::vector<long> signature;
  std::vector<int> hinges;
};

View view_of(const std::vector<Spoke>& spokes, int first, bool mirrored, int sign) {
  View view;
  const int n = static_cast<int>(spokes.size());
  for (int k = 0; k < n; ++k) {
    const int at = ((mirrored ? first - k : first + k) % n + n) % n;
    const int sector_at = mirrored ? (at + n - 1) % n : at;
    view.signature.push_back(spokes[sector_at].sector);
    view.signature.push_back(sign * spokes[at].goal);
    view.hinges.push_back(spokes[at].hinge);
  }
  return view;
}

// The views with the least signature: more than one when the vertex is symmetric.
std::vector<View> least_views(const std::vector<Spoke>& spokes) {
  std::vector<View> least;
  for (int first = 0; first < static_cast<int>(spokes.size()); ++first)
    for (const bool mirrored : {false, true})
      for (const int sign : {1, -1}) {
        View view = view_of(spokes, first, mirrored, sign);
        if (!least.empty() && least.front().signature < view.signature) continue;
        if (!least.empty() && view.signature < least.front().signature) least.clear();
        least.push_back(std::move(view));
      }
  return least;
}

std::string key_of(const std::vector<long>& signature, std::size_t place) {
  return fmt::format("{}@{}", fmt::join(signature, ","), place);
}

}  // namespace

CreaseGroups crease_groups(const Linkage& linkage) {
  CreaseGroups result;
  DisjointSets same(static_cast<std::size_t>(linkage.num_hinges()));
  std::map<std::vector<long>, int> types;
  std::map<std::string, int> holder;  // of each place: a crease that has it
  std::vector<std::set<std::string>> keys(linkage.num_hinges());
  const auto has_place = [&](int hinge, std::string key) {
    const auto [at, is_new] = holder.try_emplace(key, hinge);
    if (!is_new) same.join(hinge, at->second);
    keys[hinge].insert(std::move(key));
  };
  const std::vector<RealVertex>& vertices = linkage.loops;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].is_hole())
      throw InvalidInput("origami/hole", "symmetry is not looked for in a sheet with holes",
                         fmt::format("vertex {}", vertices[v].vertex), "plan with every crease by itself");
    const std::vector<View> views = least_views(spokes_of(vertices[v], linkage));
    const std::vector<long> signature = views.empty() ? std::vector<long>() : views.front().signature;
    const auto [type, is_new] = types.try_emplace(signature, static_cast<int>(types.size()));
    result.type.push_back(type->second);
    if (is_new) result.essential.push_back(static_cast<int>(v));
    for (const View& view : views)
      for (std::size_t k = 0; k < view.hinges.size(); ++k) has_place(view.hinges[k], key_of(signature, k));
  }
  std::map<int, int> number;
  std::vector<std::set<std::string>> group_keys;
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    const auto [at, is_new] = number.try_emplace(same.find(h), static_cast<int>(number.size()));
    result.group.push_back(at->second);
    if (is_new) group_keys.emplace_back();
    if (is_new && linkage.hinges[h].target != 0) ++result.num_moving;
    group_keys[at->second].merge(keys[h]);
  }
  for (const auto& set : group_keys) result.keys.emplace_back(set.begin(), set.end());
  result.num_groups = static_cast<int>(number.size());
  return result;
}

std::vector<int> groups_along(const FoldingPath& path, double tolerance) {
  std::vector<int> group, first;
  const int hinges = path.waypoints.empty() ? 0 : static_cast<int>(path.waypoints.front().config.size());
  for (int h = 0; h < hinges; ++h) {
    const auto like = [&](int other) {
      return std::all_of(path.waypoints.begin(), path.waypoints.end(), [&](const Waypoint& w) {
        return std::abs(std::abs(w.config[h]) - std::abs(w.config[other])) <= tolerance;
      });
    };
    const auto at = std::find_if(first.begin(), first.end(), like);
    group.push_back(static_cast<int>(at - first.begin()));
    if (at == first.end()) first.push_back(h);
  }
  return group;
}

std::vector<int> covering_vertices(const Linkage& linkage, const CreaseGroups& groups) {
  const std::vector<RealVertex>& vertices = linkage.loops;
  std::set<int> missing;
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (linkage.hinges[h].target != 0) missing.insert(groups.group[h]);
  std::vector<int> chosen;
  for (;;) {
    std::size_t best = 0;
    std::set<int> best_adds;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      std::set<int> adds;
      for (int h : vertices[v].hinges)
        if (missing.count(groups.group[h])) adds.insert(groups.group[h]);
      if (adds.size() > best_adds.size()) best = v, best_adds = std::move(adds);
    }
    if (best_adds.empty()) return chosen;
    chosen.push_back(static_cast<int>(best));
    for (int g : best_adds) missing.erase(g);
  }
}

}  // namespace plico
