// The last node that two chains of a forest share, in constant time.
#pragma once
#include <vector>

namespace plico {

// Built in O(n log n); nodes in preorder, and the shallowest parent of every run of 2^k of them (Bender, Farach-Colton,
// The LCA Problem Revisited, 2000).
class Ancestry {
 public:
  // `parent` is -1 at roots; `order` lists every node after its parent.
  Ancestry(const std::vector<int>& parent, const std::vector<int>& order);

  int depth(int node) const { return depth_[node]; }
  int common(int a, int b) const;  // -1 in different trees

 private:
  // A root has no parent (-1), which is shallower than any node.
  int shallower(int a, int b) const { return a < 0 || (b >= 0 && depth_[a] <= depth_[b]) ? a : b; }

  std::vector<int> depth_, place_;            // by node; place in preorder
  std::vector<std::vector<int>> shallowest_;  // [k][i]: of the parents of nodes at places i .. i + 2^k - 1
};

}  // namespace plico
