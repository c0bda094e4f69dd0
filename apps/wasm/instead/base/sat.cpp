// Instead of CaDiCaL: no solver. What needs one says so when it comes to it.
#include "plico/base/sat.h"

#include "plico/base/error.h"

namespace plico {

struct SatSolver::Solver {};

SatSolver::SatSolver() = default;

SatSolver::~SatSolver() = default;

void SatSolver::add(const std::vector<int>&) {}

void SatSolver::assume(int) {}

SatAnswer SatSolver::solve(const Run&) {
  throw InvalidOption("what is solved by SAT is not in this build", "use the program on a computer");
}

bool SatSolver::holds(int) const { return false; }

bool SatSolver::is_at_fault(int) const { return false; }

}  // namespace plico
