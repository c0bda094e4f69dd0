// Where a surface runs through itself.
#pragma once
#include <utility>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

// Pairs of faces (smaller first, ascending) that meet anywhere but at the vertices and edges they share; vertices with
// equal coordinates count as shared. Touching counts. Decided exactly on the triangles of each face. At most `limit`
// pairs are returned. Faces without area or with bad indices or coordinates are passed over. O(n log n + pairs).
std::vector<std::pair<int, int>> self_intersections(const PolygonSoup& soup, std::size_t limit = 10000);

}  // namespace plico
