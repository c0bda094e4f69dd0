#include "plico/stack/path_exchange.h"

#include <algorithm>
#include <cstdlib>

#include "plico/base/error.h"

namespace plico {

int SquareGraph::side_to(int square, int neighbour) const {
  const std::array<int, 4>& around = neighbours[square];
  const auto at = std::find(around.begin(), around.end(), neighbour);
  return at == around.end() ? -1 : static_cast<int>(at - around.begin());
}

void check(const SquareGraph& graph) {
  for (int s = 0; s < graph.size(); ++s) {
    for (int side = 0; side < 4; ++side) {
      const int other = graph.neighbours[s][side];
      const bool known = other >= 0 && other < graph.size() && other != s;
      if (!known || graph.side_to(s, other) != side || graph.side_to(other, s) < 0)
        throw InvalidInput("stack/no-neighbours",
                           fmt::format("side {} of square {} has no neighbour of its own", side, s),
                           fmt::format("square {}", s));
    }
  }
}

void strip_headings(const SquareGraph& graph, const std::vector<int>& path, Headings& headings, std::size_t count) {
  for (std::size_t i = headings.size(); i < count; ++i) {
    const int out = graph.side_to(path[i], path[i + 1]);
    if (out < 0)
      throw InvalidInput("stack/no-path", fmt::format("squares {} and {} are no neighbours", path[i], path[i + 1]));
    if (i == 0) {
      headings.push_back(Heading::East);
      continue;
    }
    const int in = graph.side_to(path[i], path[i - 1]);
    headings.push_back(turned(headings[i - 1], out - in - 2));
  }
}

Headings strip_headings(const SquareGraph& graph, const std::vector<int>& path) {
  Headings headings;
  if (!path.empty()) strip_headings(graph, path, headings, path.size() - 1);
  return headings;
}

PathExchange::PathExchange(const SquareGraph& graph, std::vector<int> path, int reach)
    : graph_(&graph), reach_(reach), path_(std::move(path)), place_(path_.size()) {
  for (std::size_t i = 0; i < path_.size(); ++i) place_[path_[i]] = static_cast<int>(i);
}

bool PathExchange::in_path(int a, int b) const { return std::abs(place_[a] - place_[b]) == 1; }

bool PathExchange::is_removed(int place) const {
  return std::find(removed_.begin(), removed_.end(), place) != removed_.end();
}

// Takes away one of the two path edges at a square; the other end of it.
std::optional<int> PathExchange::remove_beside(int square, int fixed, Rng& rng) {
  const int at = place_[square];
  const int last = static_cast<int>(path_.size()) - 1;
  const bool before = at > fixed && !is_removed(at - 1), after = at < last && at >= fixed && !is_removed(at);
  if (!before && !after) return {};
  const bool take_before = before && (!after || rng.below(2) == 0);
  removed_.push_back(take_before ? at - 1 : at);
  return path_[take_before ? at - 1 : at + 1];
}

// A neighbour of the square that the path does not lead to, `home` excepted.
std::optional<int> PathExchange::new_neighbour(int square, int home, int fixed, Rng& rng) const {
  std::array<int, 4> choice{};
  int choices = 0;
  for (int next : graph_->neighbours[square])
    if (place_[next] >= fixed && !in_path(square, next) && next != home) choice[choices++] = next;
  if (choices == 0) return {};
  return choice[rng.below(choices)];
}

// An alternating walk from one end of the first edge taken away back to the other. Behind the last square lies nothing,
// so a walk that begins there may end anywhere: the path then gets another end.
bool PathExchange::walk(int start, int fixed, int most, Rng& rng) {
  removed_.clear();
  added_.clear();
  const int last = static_cast<int>(path_.size()) - 1;
  const bool open = start >= last;
  const bool forward = open || rng.below(2) == 0;
  int free = path_[forward && !open ? start + 1 : start];
  const int home = open ? -1 : path_[forward ? start : start + 1];
  if (!open) removed_.push_back(start);
  for (int step = 0; step < most; ++step) {
    const bool may_close = step > 0 && !open && !in_path(free, home) && graph_->side_to(free, home) >= 0;
    if (may_close) {
      added_.push_back({free, home});
      return true;
    }
    if (open && step > 0 && rng.below(2) == 0) return true;
    const std::optional<int> next_square = new_neighbour(free, home, fixed, rng);
    if (!next_square) return false;
    const int next = *next_square;
    for (const Edge& edge : added_)
      if ((edge.a == free && edge.b == next) || (edge.a == next && edge.b == free)) return false;
    added_.push_back({free, next});
    const std::optional<int> end = remove_beside(next, fixed, rng);
    if (!end) return false;
    free = *end;
  }
  return open;
}

// Runs along the pieces that are left, over the edges added: one path when it meets all of them.
bool PathExchange::reconnect() {
  std::sort(removed_.begin(), removed_.end());
  const int pieces = static_cast<int>(removed_.size());  // behind the first, which stays
  const int last = static_cast<int>(path_.size()) - 1;
  first_ = removed_.front() + 1;
  squares_.clear();
  int at = path_[removed_.front()];
  for (int piece = 0; piece < pieces; ++piece) {
    const auto edge =
        std::find_if(added_.begin(), added_.end(), [&](const Edge& e) { return !e.used && (e.a == at || e.b == at); });
    if (edge == added_.end()) return false;
    edge->used = true;
    const int begin = place_[edge->a == at ? edge->b : edge->a];
    if (begin < first_) return false;
    const auto behind = std::lower_bound(removed_.begin(), removed_.end(), begin);
    const int high = behind == removed_.end() ? last : *behind;
    const int low = *(behind - 1) + 1;
    // The end of the path mostly stays where it is.
    if (piece + 1 == pieces && begin == low && high == last && low == first_ + static_cast<int>(squares_.size()))
      return true;
    if (begin == low)
      squares_.insert(squares_.end(), path_.begin() + low, path_.begin() + high + 1);
    else
      for (int i = high; i >= low; --i) squares_.push_back(path_[i]);
    at = squares_.back();
  }
  return static_cast<int>(squares_.size()) == last + 1 - first_;
}

bool PathExchange::is_within_reach() const {
  for (std::size_t i = 0; i < squares_.size(); ++i)
    if (std::abs(place_[squares_[i]] - first_ - static_cast<int>(i)) > reach_) return false;
  return true;
}

int PathExchange::exchange(int start, int fixed, int most, Rng& rng) {
  if (!walk(start, fixed, most, rng) || removed_.empty() || !reconnect() || !is_within_reach()) return -1;
  swap();
  return first_;
}

void PathExchange::undo() { swap(); }

void PathExchange::swap() {
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    std::swap(squares_[i], path_[first_ + i]);
    place_[path_[first_ + i]] = static_cast<int>(first_ + i);
  }
}

}  // namespace plico
