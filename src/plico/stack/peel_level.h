// What a peel can reach while one more panel is brought to its place.
#pragma once
#include <queue>
#include <unordered_map>
#include <vector>

#include "plico/base/run.h"
#include "plico/stack/peel_window.h"

namespace plico {

// Used up by the levels of one search.
struct PeelEffort {
  long nodes = 0;      // still to be looked at
  long intervals = 0;  // looked at
};

// The states of a window's hinges on a grid, from some that can be reached, shortest first. A state counts when the
// piece that leads to it is proven free (lazy A*: tried when its turn comes, so few are).
class PeelLevel {
 public:
  // `step` degrees between states, a divisor of 90; `sample` above 0: looks every so many degrees
  // instead of proving.
  PeelLevel(const PeelBodies& bodies, int first, int count, int step, double sample);

  // Begins at these angles; false when they were reached before.
  bool enter(const OpenAngles& angles);

  // From where it was entered to the next state with the first hinge as in the shape; empty when there is no other or
  // the effort or the run is over.
  std::vector<OpenAngles> next_way(PeelEffort& effort, const Run& run);

 private:
  struct Try {
    int cost, number;  // in the order of trying
    int node, from, turns;
    bool operator>(const Try& other) const { return cost != other.cost ? cost > other.cost : number > other.number; }
  };
  using Cell = std::array<int, kMostOpen>;

  int middle() const { return 180 / step_; }
  int cells() const { return 2 * middle() + 1; }
  int node_of(const OpenAngles& angles) const;
  Cell cell_of(int node) const;
  OpenAngles angles_of(int node) const;
  int moved(int node, const Cell& move) const;
  bool is_reached(const Try& next, PeelEffort& effort);
  void push_around(int node, int turns);
  std::vector<OpenAngles> way_to(int node) const;

  PeelWindow window_;
  int step_, target_;
  double sample_;
  std::vector<Cell> moves_;
  std::priority_queue<Try, std::vector<Try>, std::greater<>> tries_;
  std::unordered_map<int, int> from_;  // of every state reached; kBlocked: it collides
  int pushed_ = 0;
};

}  // namespace plico
