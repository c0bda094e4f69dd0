#include "plico/stack/decide_walk.h"

#include <algorithm>
#include <array>
#include <cadical.hpp>

#include "plico/base/error.h"

namespace plico {
namespace {

class RunTerminator : public CaDiCaL::Terminator {
 public:
  explicit RunTerminator(const Run& run) : run_(run) {}
  bool terminate() override { return run_.over(); }

 private:
  const Run& run_;
};

// One variable a pair of neighbours: the walk goes from one to the other.
class WalkFormula {
 public:
  explicit WalkFormula(const SquareGraph& graph) : graph_(graph), link_(graph.size()) {
    solver_.set("quiet", 1);  // it prints otherwise
    for (int s = 0; s < graph.size(); ++s)
      for (int side = 0; side < 4; ++side) {
        const int other = graph.neighbours[s][side];
        link_[s][side] = other > s ? ++variables_ : link_[other][graph.side_to(other, s)];
      }
  }

  CaDiCaL::Solver& solver() { return solver_; }

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
        add(some);
        add(not_all);
      }
      add({link_[s].begin(), link_[s].end()});
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
    add(out);
  }

 private:
  void add(const std::vector<int>& clause) {
    for (int literal : clause) solver_.add(literal);
    solver_.add(0);
  }

  // Counts along the row: one[i] and two[i] hold when at least one, two of the first i + 1 do.
  void at_most_two(const std::vector<int>& literals) {
    int one = 0, two = 0;
    for (int literal : literals) {
      const int next_one = ++variables_, next_two = ++variables_;
      add({-literal, next_one});
      if (one != 0) {
        add({-one, next_one});
        add({-one, -literal, next_two});
        add({-two, next_two});
        add({-two, -literal});
      }
      one = next_one;
      two = next_two;
    }
  }

  bool linked(int square, int side) { return solver_.val(link_[square][side]) > 0; }
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
  CaDiCaL::Solver solver_;
  int variables_ = 0;
};

}  // namespace

WalkDecision decide_walk(const SquareGraph& graph, Walk walk, const Run& run) {
  check(graph);
  if (graph.size() == 0) throw InvalidInput("stack/empty", "there is no square");
  WalkFormula formula(graph);
  RunTerminator terminator(run);
  formula.solver().connect_terminator(&terminator);
  formula.ask_for(walk);
  WalkDecision decision;
  for (;;) {
    constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
    const int status = run.over() ? 0 : formula.solver().solve();
    if (status == kUnsatisfiable) break;
    if (status != kSatisfiable) {
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
  formula.solver().disconnect_terminator();
  return decision;
}

}  // namespace plico
