// MD-FROG: a planner for rigid origami with several degrees of freedom. Source: [Xi17] 3.2.
#pragma once
#include <functional>
#include <optional>

#include "plico/origami/discrete_states.h"
#include "plico/origami/frog.h"

namespace plico {

struct MdFrogOptions {
  DiscreteOptions discrete = {};  // the states of the roadmap; within the limits of the hinges
  long max_states = 2000;         // of the roadmap, at least 0; beyond them the first in lexical order are used
  // Gauss-Newton or NLopt, step and weights of the nonlinear connections; max_samples holds for each of them.
  FrogOptions frog = {.step = 0.25, .initial_weight = 1, .reward = 0.2, .penalty = 0.01, .max_samples = 300};
  std::vector<Configuration> intermediate = {};  // to be passed in this order, by the user; each must close
  int alternatives = 1;                          // paths wanted, at least 1
  long max_connections = 20000;                  // tried, at least 0
  // A closer look at a path: the time at which it fails there, if it does. The connection at that time is removed, and
  // the search goes on, after at most `max_refuted` of them.
  std::function<std::optional<double>(const FoldingPath&)> refute = {};
  int max_refuted = 300;    // at least 0
  int linear_samples = 32;  // configurations looked at along a linear connection, at least 1
};

// How two neighbouring states of a path were connected.
enum class Connection { Linear, Nonlinear };

struct MdFrogPath {
  FoldingPath path;                     // waypoints close and are free of collision; times by distance
  std::vector<Configuration> states;    // of the roadmap, from flat to the goal
  std::vector<double> times;            // of these
  std::vector<Connection> connections;  // one fewer
};

struct MdFrogResult {
  Ending ending = Ending::Exhausted;  // Found: as many paths as asked for
  std::vector<MdFrogPath> paths;      // shortest first
  long states = 0;                    // in the roadmap: "valid" of tables 3.1 and 3.2
  long samples = 0;                   // configurations looked at on connections
  long tested = 0;                    // evaluations of the closure, those for the states included
  long connections_tried = 0;
  int refuted = 0;            // paths
  double worst_residual = 0;  // of all waypoints, radians
};

// A lazy roadmap over the discrete states, searched from flat to the goal for a short way (by the square of the
// distance, so that what can be folded in small steps is). Connections are tried when the search gets to them. One is
// linear if all configurations between two states close and are free of collision, else nonlinear, by FROG. Panels that
// come to lie on each other in a state have an order, which the way there decides: the search is over states and their
// orders of layers (layers.h), and no connection leads panels apart on another side than the one that they came from.
// A further path must pass through other states and must not blend into an earlier one through foldable configurations
// without collision (evidence, not proof, of another homotopy class). Deterministic for a seed. Throws InvalidInput
// when the goal or an intermediate state does not close or lies beyond a limit ("fold/limits").
MdFrogResult md_frog(const Linkage& linkage, const MdFrogOptions& options = {}, const Run& run = {});
inline MdFrogResult md_frog(const CreasePattern& sheet, const MdFrogOptions& options = {}, const Run& run = {}) {
  return md_frog(make_linkage(sheet), options, run);
}

}  // namespace plico
