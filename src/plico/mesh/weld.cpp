#include "plico/mesh/weld.h"

#include <algorithm>
#include <numeric>

namespace plico {

std::vector<int> welded_points(const std::vector<Vec3>& points) {
  std::vector<int> first(points.size()), order;
  std::iota(first.begin(), first.end(), 0);
  for (int i : first)
    if (points[i].allFinite()) order.push_back(i);
  const auto less = [&](int a, int b) {
    const Vec3 &p = points[a], &q = points[b];
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] != q[axis]) return p[axis] < q[axis];
    return a < b;
  };
  std::sort(order.begin(), order.end(), less);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i]] == points[order[i - 1]]) first[order[i]] = first[order[i - 1]];
  return first;
}

}  // namespace plico
