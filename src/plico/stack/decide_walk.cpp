#include "plico/stack/decide_walk.h"

#include <algorithm>
#include <array>

#include "plico/base/error.h"
#include "plico/base/sat.h"

namespace plico {
namespace {

// One variable a pair of neighbours: the walk goes from one to the other.
class WalkFormula {
 public:
  explicit WalkFormula(const SquareGraph& graph) : graph_(graph), link_(graph.size()) {
    for (int s = 0; s < graph.size(); ++s)
      for (int side = 0; side < 4; ++side) {
        const int other = graph.neighbours[s][side];
        link_[s][side] = other > s ? ++variables_ : link_[other][graph.side_to(other, s)];
      }
  }

  SatAnswer solve(const Run& run) { return solver_.solve(run); }

  void ask_for(Walk walk) {
    std::vector<int> ends;  // one variable a square: the path may end there
    for (int s = 0; s < graph_.size(); ++s) {
      const int end = walk == Walk::Path ? ++variables_ : 0;
      if (end != 0) ends.push_back(end);
      // Of any three sides at least one is taken and at most two, so of all four two; one fewer at an end.
      for (int out = 0; out < 4; ++out) {
        std::vector<int> some, not_all;
        for (int side = 0; side < 4; ++side)
          if (side != out) some.push_back(link_[s][side]), not_all.push_back(-link_[s][side]);
        if (end != 0) some.push_back(end);
        solver_.add(some);
        solver_.add(not_all);
      }
      solver_.add({link_[s].begin(), link_[s].end()});
    }
    at_most_two(ends);
  }

  // The walks that the solver's answer consists of.
  std::vector<std::vector<int>> walks() {
    std::vector<std::vector<int>> walks;
    seen_.assign(graph_.size(), 0);
    // Ends first, so that a path is walked from one end to the other.
    for (const bool from_ends : {true, false})
      for (int s = 0; s < graph_.size(); ++s)
        if (!seen_[s] && (!from_ends || links_at(s) == 1)) walks.push_back(walk_from(s));
    return walks;
  }

  // Some link must lead out of these squares.
  void cut(const std::vector<int>& squares) {
    std::vector<char> inside(graph_.size(), 0);
    for (int s : squares) inside[s] = 1;
    std::vector<int> out;
    for (int s : squares)
      for (int side = 0; side < 4; ++side)
        if (!inside[graph_.neighbours[s][side]]) out.push_back(link_[s][side]);
    solver_.add(out);
  }

 private:
  // Counts along the row: one[i] and two[i] hold when at least one, two of the first i + 1 do.
  void at_most_two(const std::vector<int>& literals) {
    int one = 0, two = 0;
    for (int literal : literals) {
      const int next_one = ++variables_, next_two = ++variables_;
      solver_.add({-literal, next_one});
      if (one != 0) {
        solver_.add({-one, next_one});
        solver_.add({-one, -literal, next_two});
        solver_.add({-two, next_two});
        solver_.add({-two, -literal});
      }
      one = next_one;
      two = next_two;
    }
  }

  bool linked(int square, int side) { return solver_.holds(link_[square][side]); }
  int links_at(int square) {
    int count = 0;
    for (int side = 0; side < 4; ++side) count += linked(square, side);
    return count;
  }
  std::vector<int> walk_from(int square) {
    std::vector<int> walk;
    for (int at = square; at >= 0;) {
      seen_[at] = 1;
      walk.push_back(at);
      int next = -1;
      for (int side = 0; side < 4 && next < 0; ++side)
        if (linked(at, side) && !seen_[graph_.neighbours[at][side]]) next = graph_.neighbours[at][side];
      at = next;
    }
    return walk;
  }

  const SquareGraph& graph_;
  std::vector<std::array<int, 4>> link_;
  std::vector<char> seen_;
  SatSolver solver_;
  int variables_ = 0;
};

}  // namespace

WalkDecision decide_walk(const SquareGraph& graph, Walk walk, const Run& run) {
  check(graph);
  if (graph.size() == 0) throw InvalidInput("stack/empty", "there is no square");
  WalkFormula formula(graph);
  formula.ask_for(walk);
  WalkDecision decision;
  for (;;) {
    const SatAnswer answer = formula.solve(run);
    if (answer == SatAnswer::Unsatisfiable) break;
    if (answer == SatAnswer::RunOver) {
      decision.ending = run.ending();
      break;
    }
    std::vector<std::vector<int>> walks = formula.walks();
    if (walks.size() == 1) {
      decision.ending = Ending::Found;
      decision.squares = std::move(walks.front());
      break;
    }
    for (const std::vector<int>& part : walks) formula.cut(part);
    decision.cuts += static_cast<int>(walks.size());
  }
  return decision;
}

}  // namespace plico
