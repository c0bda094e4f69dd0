#include "plico/base/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace plico {

DisjointSets::DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

int DisjointSets::find(int i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

void DisjointSets::join(int i, int j) {
  const int a = find(i), b = find(j);
  parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace plico
