// Cycles of numbers that are cut and joined again: every number 0..n-1 is in exactly one sequence, read as a cycle.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "plico/base/rng.h"

namespace plico {

// Balanced trees (treaps) with lazily reversed subtrees: position, cut, join and reversal each O(log n) expected, so
// that exchanging a few links of a cycle of a million costs microseconds. Sequences are named by their trees' roots,
// which change when they are cut or joined.
class CyclicSequences {
 public:
  CyclicSequences(int n, Rng rng);  // every number is a sequence of its own

  int root(int v) const;
  int position(int v) const;  // from 0, in its sequence
  int size(int root) const { return nodes_[root].size; }
  int at(int root, int position);

  int join(int first, int second);                  // roots -> root of first followed by second; -1 is the empty one
  std::pair<int, int> cut(int root, int position);  // -> [0, position), [position, size); -1 for an empty one
  void reverse(int root);

  std::vector<int> sequence(int root);

 private:
  struct Node {
    int parent = -1, left = -1, right = -1, size = 1;
    std::uint32_t priority = 0;
    bool reversed = false;  // to be handed on to both children
  };

  int size_of(int node) const { return node < 0 ? 0 : nodes_[node].size; }
  void hand_on_reversal(int node);
  void renew(int node);

  std::vector<Node> nodes_;
};

}  // namespace plico
