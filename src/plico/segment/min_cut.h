// The cheapest set of edges whose removal parts the sources from the sinks of an undirected graph.
#pragma once
#include <vector>

namespace plico {

class MinCut {
 public:
  explicit MinCut(int num_nodes);

  // `capacity` must not be negative; nodes in [0, num_nodes).
  void add_edge(int a, int b, double capacity);
  void make_source(int node) { terminal_[node] = 1; }
  void make_sink(int node) { terminal_[node] = -1; }

  // Returns the cost of the cut. There must be a source and a sink. Blocking flows (Dinitz 1970): O(n^2 m), nearly
  // linear on bands of meshes. An exact minimum up to the rounding of sums.
  double solve();
  // After solve(): the nodes that sources reach, as few as any minimum cut leaves them.
  bool on_source_side(int node) const { return level_[node] >= 0; }

 private:
  struct Half {
    int to;
    double left;  // capacity; the other direction is the next or the previous half
  };
  bool find_levels();
  double push_along_paths(int source);

  std::vector<std::vector<int>> halves_at_;
  std::vector<Half> halves_;
  std::vector<int> terminal_, level_;
  std::vector<std::size_t> next_;  // half of each node to be tried next
};

}  // namespace plico
