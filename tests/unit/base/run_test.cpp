#include "plico/base/run.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace plico {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceForAnyThreadCount) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for({.threads = threads}, 1000, [&](int i) { ++visits[i]; });
    for (const std::atomic<int>& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, RethrowsTheFailureOfTheSmallestIndex) {
  try {
    parallel_for({.threads = 4}, 100, [](int i) {
      if (i % 10 == 3) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
}

TEST(ParallelFor, NothingToDoIsFine) {
  parallel_for({.threads = 4}, 0, [](int) { FAIL(); });
}

TEST(RunTest, EndsByStopOrByDeadline) {
  EXPECT_FALSE(plico::Run{}.over());
  std::stop_source source;
  const plico::Run run{.stop = source.get_token()};
  source.request_stop();
  EXPECT_TRUE(run.over());
  EXPECT_EQ(run.ending(), Ending::Stopped);
  const plico::Run late = limited({}, 0);
  EXPECT_TRUE(late.over());
  EXPECT_EQ(late.ending(), Ending::TimedOut);
}

TEST(RunTest, ALimitNeverLengthensADeadline) {
  const plico::Run shortened = limited({}, 1);
  EXPECT_EQ(limited(shortened, 100).deadline, shortened.deadline);
}

}  // namespace
}  // namespace plico
