#pragma once
#include <cstddef>
#include <vector>

namespace plico {

// Disjoint sets of 0..n-1.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n);
  int find(int i);
  void join(int i, int j);  // the smaller root stays

 private:
  std::vector<int> parent_;
};

}  // namespace plico
