// Sampling in the discrete domain: the foldable configurations in which every crease has one of a few angles.
// Source: [Xi17] 3.2.1 and table 3.2, read as R6.
#pragma once
#include <cstdint>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/linkage.h"

namespace plico {

enum class AngleSet { Discrete3, Discrete4 };

// {0, sign pi, target}, and sign pi / 2 for Discrete4; each size at most `limit`, in this order, none twice. A crease
// whose target is 0 stays flat. Angles in radians.
std::vector<double> important_angles(double target, AngleSet set, double limit = kPi);

struct DiscreteOptions {
  AngleSet angles = AngleSet::Discrete3;
  double tolerance = 1e-9;       // radians, of the worst closure residual; above 0
  std::vector<int> groups = {};  // of each hinge: creases of one group (0, 1, ...) take the same place in their angle
                                 // sets, each with its own sign; empty: every crease for itself
};

struct DiscreteStates {
  Ending ending = Ending::Found;      // Found: complete
  std::vector<Configuration> states;  // flat first; each closes, panels may lie on each other
  long tested = 0;                    // vertices walked around
};

inline constexpr long kMostTested = 2000000;  // about two seconds

// All of them, in lexical order, by choosing the angles vertex after vertex and going on only where the loop closes;
// at most `most`, and after kMostTested vertices walked around, then the search ends Exhausted. Collisions are not
// looked at: panels that lie on each other make most of these states, and touching is allowed. Exponential in the worst
// case; 0.01 s for the 32 creases of the sailboat. Throws InvalidInput when `groups` does not fit or joins creases of
// different angle sets. Sizes are at most the limits of the hinges; targets beyond are clamped as well.
DiscreteStates discrete_states(const Linkage& linkage, const DiscreteOptions& options = {}, long most = 100000,
                               const Run& run = {});
inline DiscreteStates discrete_states(const CreasePattern& sheet, const DiscreteOptions& options = {},
                                      long most = 100000, const Run& run = {}) {
  return discrete_states(make_linkage(sheet), options, most, run);
}

// As the dissertation has it: `samples` random choices, each new one (a hash set knows) tested; in the order found.
DiscreteStates sample_discrete_states(const Linkage& linkage, const DiscreteOptions& options, long samples,
                                      std::uint64_t seed = 1, const Run& run = {});

// Creases whose fold angles have the same size, each in its own sign, in all of `states` form one group, numbered by
// first hinge.
std::vector<int> groups_of(const std::vector<Configuration>& states);

}  // namespace plico
