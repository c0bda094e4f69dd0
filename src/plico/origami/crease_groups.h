// Symmetry: creases that trace out the same trajectory, and the vertices that decide what all others do.
// Source: [Xi17] 3.3.1.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/folding_path.h"

namespace plico {

struct CreaseGroups {
  std::vector<int> group;  // of each hinge, 0 ... k - 1 by first hinge; creases whose goal is 0 are groups of one
  int num_groups = 0;
  int num_moving = 0;                          // groups whose goal is not 0
  std::vector<int> type;                       // of each real vertex, as Linkage::loops lists them, by first vertex
  std::vector<int> essential;                  // the first vertex of each type, indices as above
  std::vector<std::vector<std::string>> keys;  // of each group: the places it has around vertices, ascending
};

// Two real vertices are of one type when the creases around them, their sector angles and their goals agree up to
// rotation, reflection and turning all creases over, under which closure does not change. Creases at corresponding
// places of vertices of one type form one group, and so do those that share a member. Creases that stay flat are left
// out. Hence if the essential vertices close while groups move as one, all of them do. Angles agree when they differ by
// less than 1e-5 degrees. O(creases * degree^2). Throws InvalidInput for a sheet with holes.
CreaseGroups crease_groups(const Linkage& linkage);
inline CreaseGroups crease_groups(const CreasePattern& sheet) { return crease_groups(make_linkage(sheet)); }

// The same from a solved motion: creases whose fold angles have equal sizes, within `tolerance` radians, at all
// waypoints. O(waypoints * creases * groups).
std::vector<int> groups_along(const FoldingPath& path, double tolerance = 1e-9);

// The dissertation's essential vertices: few real vertices whose creases together meet every group that moves. Greedy,
// the one that adds most first. Fewer than types, and not always enough: a vertex type that is left out may ask for
// more than the others do.
std::vector<int> covering_vertices(const Linkage& linkage, const CreaseGroups& groups);

}  // namespace plico
