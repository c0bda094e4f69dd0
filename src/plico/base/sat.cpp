#include "plico/base/sat.h"

#include <cadical.hpp>

namespace plico {
namespace {

class RunTerminator : public CaDiCaL::Terminator {
 public:
  explicit RunTerminator(const Run& run) : run_(run) {}
  bool terminate() override { return run_.over(); }

 private:
  const Run& run_;
};

}  // namespace

struct SatSolver::Solver : CaDiCaL::Solver {};

SatSolver::SatSolver() : solver_(std::make_unique<Solver>()) { solver_->set("quiet", 1); }  // it prints otherwise

SatSolver::~SatSolver() = default;

void SatSolver::add(const std::vector<int>& clause) {
  for (int literal : clause) solver_->add(literal);
  solver_->add(0);
}

void SatSolver::assume(int literal) { solver_->assume(literal); }

SatAnswer SatSolver::solve(const Run& run) {
  constexpr int kSatisfiable = 10, kUnsatisfiable = 20;
  if (run.over()) return SatAnswer::RunOver;
  RunTerminator terminator(run);
  solver_->connect_terminator(&terminator);
  const int status = solver_->solve();
  solver_->disconnect_terminator();
  if (status == kSatisfiable) return SatAnswer::Satisfiable;
  return status == kUnsatisfiable ? SatAnswer::Unsatisfiable : SatAnswer::RunOver;
}

bool SatSolver::holds(int variable) const { return solver_->val(variable) > 0; }

bool SatSolver::is_at_fault(int literal) const { return solver_->failed(literal); }

}  // namespace plico
