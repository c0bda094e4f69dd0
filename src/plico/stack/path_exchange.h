// Other Hamiltonian paths near a given one: edges of the path are exchanged for others of the graph, alternately, and
// the result is kept when it still is one path. Only squares behind a chosen place change theirs.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "plico/base/rng.h"
#include "plico/stack/lattice.h"

namespace plico {

// The dual graph of a surface of squares: the four neighbours of each square, counter-clockwise seen from outside.
// Every neighbour is a neighbour by one side only, both ways.
struct SquareGraph {
  std::vector<std::array<int, 4>> neighbours;
  int size() const { return static_cast<int>(neighbours.size()); }
  int side_to(int square, int neighbour) const;  // -1: not a neighbour
};

// Throws InvalidInput when a neighbour does not name its neighbour back, or names it twice.
void check(const SquareGraph& graph);

// The headings of a path through the squares, the first one East. Appends until there are `count`; those already there
// stay. Throws InvalidInput when two squares in a row are no neighbours.
void strip_headings(const SquareGraph& graph, const std::vector<int>& path, Headings& headings, std::size_t count);
Headings strip_headings(const SquareGraph& graph, const std::vector<int>& path);

class PathExchange {
 public:
  // `path` visits every square once. No exchange moves a square by more than `reach` places.
  PathExchange(const SquareGraph& graph, std::vector<int> path, int reach = std::numeric_limits<int>::max());

  // Walks at random: takes away an edge near place `start`, adds one of the graph, takes away ... up to `most` times,
  // and closes up. When the result is one path it becomes the path, and the first place with another square is told;
  // -1 when nothing changed. Places up to `fixed` keep their squares. O(most^2 + squares moved).
  int exchange(int start, int fixed, int most, Rng& rng);
  void undo();  // the last exchange, once

  const std::vector<int>& path() const { return path_; }
  // Of the last exchange, until it is undone: the squares that were there before, from that place on.
  int first_changed() const { return first_; }
  const std::vector<int>& squares_before() const { return squares_; }

 private:
  struct Edge {
    int a, b;
    bool used = false;
  };
  bool walk(int start, int fixed, int most, Rng& rng);
  bool in_path(int a, int b) const;
  std::optional<int> new_neighbour(int square, int home, int fixed, Rng& rng) const;
  bool is_removed(int place) const;  // the edge behind it
  std::optional<int> remove_beside(int square, int fixed, Rng& rng);
  bool reconnect();
  bool is_within_reach() const;
  void swap();

  const SquareGraph* graph_;
  int reach_;
  std::vector<int> path_, place_;
  std::vector<int> removed_;  // places; the edge from each to the next is taken away
  std::vector<Edge> added_;
  int first_ = 0;             // place
  std::vector<int> squares_;  // from there on, before or after the exchange
};

}  // namespace plico
