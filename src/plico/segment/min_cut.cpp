#include "plico/segment/min_cut.h"

#include <algorithm>
#include <limits>

namespace plico {

MinCut::MinCut(int num_nodes) : halves_at_(num_nodes), terminal_(num_nodes, 0), level_(num_nodes, -1) {}

void MinCut::add_edge(int a, int b, double capacity) {
  halves_at_[a].push_back(static_cast<int>(halves_.size()));
  halves_.push_back({b, capacity});
  halves_at_[b].push_back(static_cast<int>(halves_.size()));
  halves_.push_back({a, capacity});
}

// Breadth first from all sources along edges with capacity left.
bool MinCut::find_levels() {
  std::fill(level_.begin(), level_.end(), -1);
  std::vector<int> queue;
  for (std::size_t v = 0; v < terminal_.size(); ++v)
    if (terminal_[v] > 0) level_[v] = 0, queue.push_back(static_cast<int>(v));
  bool reached = false;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int v = queue[i];
    if (terminal_[v] < 0) {
      reached = true;
      continue;
    }
    for (int h : halves_at_[v])
      if (halves_[h].left > 0 && level_[halves_[h].to] < 0)
        level_[halves_[h].to] = level_[v] + 1, queue.push_back(halves_[h].to);
  }
  return reached;
}

// Pushes what fits along shortest paths, one path after the other, by depth first search with an explicit stack.
double MinCut::push_along_paths(int source) {
  double total = 0;
  std::vector<int> path;  // halves
  while (true) {
    const int at = path.empty() ? source : halves_[path.back()].to;
    if (terminal_[at] < 0) {
      double least = std::numeric_limits<double>::infinity();
      for (int h : path) least = std::min(least, halves_[h].left);
      std::size_t full = path.size();
      for (std::size_t i = path.size(); i-- > 0;) {
        halves_[path[i]].left -= least;
        halves_[path[i] ^ 1].left += least;
        if (halves_[path[i]].left <= 0) full = i;
      }
      total += least;
      path.resize(full);
      continue;
    }
    std::size_t& i = next_[at];
    const std::vector<int>& around = halves_at_[at];
    while (i < around.size() && !(halves_[around[i]].left > 0 && level_[halves_[around[i]].to] == level_[at] + 1)) ++i;
    if (i < around.size()) {
      path.push_back(around[i]);
    } else if (path.empty()) {
      return total;
    } else {
      path.pop_back();
      ++next_[path.empty() ? source : halves_[path.back()].to];
    }
  }
}

double MinCut::solve() {
  double total = 0;
  while (find_levels()) {
    next_.assign(halves_at_.size(), 0);
    for (std::size_t v = 0; v < terminal_.size(); ++v)
      if (terminal_[v] > 0) total += push_along_paths(static_cast<int>(v));
  }
  return total;
}

}  // namespace plico
