#include "plico/origami/reuse.h"

#include <cmath>
#include <map>

#include "plico/base/error.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

// A crease of `small` that moves as each group of `large` does, or -1 for groups that stay flat.
std::vector<int> models(const CreaseGroups& small, const std::vector<int>& small_first, const CreaseGroups& large,
                        const Linkage& linkage) {
  std::map<std::string, int> crease_at;
  for (int g = 0; g < small.num_groups; ++g)
    for (const std::string& key : small.keys[g]) crease_at.emplace(key, small_first[g]);
  std::vector<int> model(large.num_groups, -1);
  for (int h = linkage.num_hinges() - 1; h >= 0; --h) {
    const int g = large.group[h];
    if (linkage.hinges[h].target == 0) continue;
    for (const std::string& key : large.keys[g])
      if (const auto at = crease_at.find(key); at != crease_at.end()) model[g] = at->second;
    if (model[g] < 0)
      throw InvalidInput("origami/no-model", "the small pattern has no crease like this one",
                         fmt::format("crease {} of the large pattern", h),
                         "use a small pattern with every type of vertex of the large one, and the same goals");
  }
  return model;
}

}  // namespace

FoldingPath reuse_path(const Linkage& small, const FoldingPath& path, const Linkage& large) {
  const CreaseGroups from = crease_groups(small), to = crease_groups(large);
  PLICO_ASSERT(path.waypoints.empty() || path.waypoints.front().config.size() == small.num_hinges());
  std::vector<int> first(from.num_groups, -1);
  for (int h = static_cast<int>(from.group.size()) - 1; h >= 0; --h) first[from.group[h]] = h;
  for (const Waypoint& waypoint : path.waypoints)
    for (std::size_t h = 0; h < from.group.size(); ++h) {
      const double own = waypoint.config[static_cast<int>(h)], firsts = waypoint.config[first[from.group[h]]];
      if (std::abs(std::abs(own) - std::abs(firsts)) > 1e-6)
        throw InvalidInput("origami/no-group", "creases of one group do not move alike along the path",
                           fmt::format("creases {} and {} at time {}", first[from.group[h]], h, waypoint.time));
    }
  const std::vector<int> model = models(from, first, to, large);
  FoldingPath result;
  for (const Waypoint& waypoint : path.waypoints) {
    Configuration config = Configuration::Zero(large.num_hinges());
    for (int h = 0; h < large.num_hinges(); ++h)
      if (const int m = model[to.group[h]]; m >= 0)
        config[h] = large.hinges[h].target * small.hinges[m].target > 0 ? waypoint.config[m] : -waypoint.config[m];
    result.waypoints.push_back({waypoint.time, std::move(config)});
  }
  return result;
}

WaypointCheck check_waypoints(const Linkage& linkage, const FoldingPath& path, const CollisionOptions& options,
                              const Run& run) {
  const std::vector<RealVertex>& vertices = linkage.loops;
  const int n = static_cast<int>(path.waypoints.size());
  std::vector<Closure> closures(n);
  std::vector<std::vector<PanelPair>> collisions(n);
  std::vector<char> done(n, 0);
  parallel_for(run, n, [&](int i) {
    if (run.over()) return;
    closures[i] = closure(vertices, path.waypoints[i].config);
    CollisionChecker checker(linkage, options);
    collisions[i] = checker.collisions(path.waypoints[i].config);
    done[i] = 1;
  });
  WaypointCheck result;
  for (int i = 0; i < n; ++i) {
    if (!done[i]) result.ending = run.ending();
    if (closures[i].worst > result.worst_residual) {
      result.worst_residual = closures[i].worst;
      result.vertex = closures[i].worst_vertex;
    }
    if (result.waypoint < 0 && !collisions[i].empty()) {
      result.waypoint = i;
      result.panels = collisions[i].front();
    }
  }
  return result;
}

}  // namespace plico
