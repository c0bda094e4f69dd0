#include "plico/verify/ancestry.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace plico {

Ancestry::Ancestry(const std::vector<int>& parent, const std::vector<int>& order)
    : depth_(parent.size(), 0), place_(parent.size(), 0) {
  const std::size_t n = parent.size();
  std::vector<int> size(n, 1), next(n, 0);
  for (std::size_t i = n; i-- > 0;)
    if (const int p = parent[order[i]]; p >= 0) size[p] += size[order[i]];
  std::vector<int>& parents = shallowest_.emplace_back(n, -1);
  int roots = 0;
  for (int node : order) {
    const int p = parent[node];
    int& free = p < 0 ? roots : next[p];
    place_[node] = free;
    free += size[node];
    next[node] = place_[node] + 1;
    depth_[node] = p < 0 ? 0 : depth_[p] + 1;
    parents[place_[node]] = p;
  }
  for (std::size_t run = 2; run <= n; run *= 2) {
    const std::vector<int>& half = shallowest_.back();
    std::vector<int> whole(n - run + 1);
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = shallower(half[i], half[i + run / 2]);
    shallowest_.push_back(std::move(whole));
  }
}

// The nodes after the first one up to the second, in preorder, hang below the last common node, and one of them is its
// child. A root among them begins another tree.
int Ancestry::common(int a, int b) const {
  if (a == b) return a;
  const auto [before, last] = std::minmax(place_[a], place_[b]);
  const auto count = static_cast<unsigned>(last - before);
  const int k = std::bit_width(count) - 1;
  return shallower(shallowest_[k][before + 1], shallowest_[k][last + 1 - (1 << k)]);
}

}  // namespace plico
