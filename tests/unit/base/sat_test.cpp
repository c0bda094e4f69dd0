#include "plico/base/sat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iterator>
#include <random>
#include <vector>

namespace plico {
namespace {

TEST(SatSolver, FindsTheOnlyAssignmentThenNoneOnceItIsForbidden) {
  SatSolver solver;
  solver.add({1, 2});
  solver.add({-1, 2});
  solver.add({1, -2});
  ASSERT_EQ(solver.solve({}), SatAnswer::Satisfiable);
  EXPECT_TRUE(solver.holds(1));
  EXPECT_TRUE(solver.holds(2));
  solver.add({-1, -2});
  EXPECT_EQ(solver.solve({}), SatAnswer::Unsatisfiable);
}

TEST(SatSolver, NamesTheAssumptionsThatClash) {
  SatSolver solver;
  solver.add({-1, -2});
  for (int literal : {1, 2, 3}) solver.assume(literal);
  ASSERT_EQ(solver.solve({}), SatAnswer::Unsatisfiable);
  EXPECT_TRUE(solver.is_at_fault(1));
  EXPECT_TRUE(solver.is_at_fault(2));
  EXPECT_FALSE(solver.is_at_fault(3));
  EXPECT_EQ(solver.solve({}), SatAnswer::Satisfiable) << "an assumption is for one answer alone";
}

// Small formulas against all of their assignments; what is at fault cannot hold by itself, and clauses come in between.
TEST(SatSolver, AgreesWithTryingAll) {
  constexpr int kVariables = 9, kFormulas = 200, kRounds = 4;
  std::mt19937 draw(1);
  const auto literal = [&] { return (1 + static_cast<int>(draw() % kVariables)) * (draw() % 2 ? 1 : -1); };
  const auto holds_in = [](unsigned bits, int lit) {
    return (bits >> (std::abs(lit) - 1) & 1U) == (lit > 0 ? 1U : 0U);
  };
  int satisfiable = 0;
  for (int formula = 0; formula < kFormulas; ++formula) {
    SatSolver solver;
    std::vector<std::vector<int>> clauses;
    const auto possible = [&](const std::vector<int>& assumed) {
      for (unsigned bits = 0; bits < 1U << kVariables; ++bits)
        if (std::ranges::all_of(assumed, [&](int lit) { return holds_in(bits, lit); }) &&
            std::ranges::all_of(clauses, [&](const std::vector<int>& clause) {
              return std::ranges::any_of(clause, [&](int lit) { return holds_in(bits, lit); });
            }))
          return true;
      return false;
    };
    for (int round = 0; round < kRounds; ++round) {
      for (int i = 0; i < (round == 0 ? 28 : 3); ++i) {
        clauses.push_back({literal(), literal(), literal()});
        solver.add(clauses.back());
      }
      std::vector<int> assumed(round), at_fault;
      for (int& lit : assumed) solver.assume(lit = literal());
      const bool found = solver.solve({}) == SatAnswer::Satisfiable;
      ASSERT_EQ(found, possible(assumed)) << formula << ' ' << round;
      satisfiable += found;
      for (const std::vector<int>& clause : clauses)
        EXPECT_TRUE(!found ||
                    std::ranges::any_of(clause, [&](int lit) { return solver.holds(std::abs(lit)) == (lit > 0); }));
      if (found) continue;
      std::ranges::copy_if(assumed, std::back_inserter(at_fault), [&](int lit) { return solver.is_at_fault(lit); });
      EXPECT_FALSE(possible(at_fault)) << formula << ' ' << round;
    }
  }
  EXPECT_GT(satisfiable, kFormulas / 2);
}

// Pigeons and holes: out of reach of resolution, so it is the stop that ends it.
TEST(SatSolver, EndsWithTheRun) {
  SatSolver solver;
  constexpr int kHoles = 14;
  const auto sits = [](int pigeon, int hole) { return pigeon * kHoles + hole + 1; };
  for (int pigeon = 0; pigeon <= kHoles; ++pigeon) {
    std::vector<int> somewhere;
    for (int hole = 0; hole < kHoles; ++hole) {
      somewhere.push_back(sits(pigeon, hole));
      for (int other = 0; other < pigeon; ++other) solver.add({-sits(pigeon, hole), -sits(other, hole)});
    }
    solver.add(somewhere);
  }
  const plico::Run run{.deadline = Run::Clock::now() + std::chrono::milliseconds(50)};
  EXPECT_EQ(solver.solve(run), SatAnswer::RunOver);
  EXPECT_EQ(run.ending(), Ending::TimedOut);
}

}  // namespace
}  // namespace plico
