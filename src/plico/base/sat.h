// Boolean formulas, decided by CaDiCaL.
#pragma once
#include <memory>
#include <vector>

#include "plico/base/run.h"

namespace plico {

enum class SatAnswer { Satisfiable, Unsatisfiable, RunOver };

// Clauses over variables 1, 2, ...; a literal is a variable or its negative. Clauses may be added between two answers.
class SatSolver {
 public:
  SatSolver();
  ~SatSolver();
  SatSolver(const SatSolver&) = delete;
  SatSolver& operator=(const SatSolver&) = delete;

  void add(const std::vector<int>& clause);  // one of the literals holds
  void assume(int literal);                  // it holds, for the next answer alone
  SatAnswer solve(const Run& run);

  bool holds(int variable) const;       // in the assignment found: after Satisfiable
  bool is_at_fault(int literal) const;  // what was assumed is part of the reason: after Unsatisfiable

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace plico
