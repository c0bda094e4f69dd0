#include "plico/base/sat.h"

#include <gtest/gtest.h>

#include <chrono>
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
