#include "stop_signal.h"

#include <gtest/gtest.h>

#include <future>

namespace plico::cli {
namespace {

using namespace std::chrono_literals;

TEST(StopSignal, WorkThatWaitsOnAfterItsTimeLimitIsGivenUpUnlessItWrites) {
  std::promise<jobs::ExitCode> given_up;
  std::atomic<bool> other_given_up = false;
  StopSignal waiting(0.01, [&](jobs::ExitCode exit_code) { given_up.set_value(exit_code); });
  StopSignal writing(0.01, [&](jobs::ExitCode) { other_given_up = true; });
  writing.let_end();
  std::future<jobs::ExitCode> how = given_up.get_future();
  ASSERT_EQ(how.wait_for(20s), std::future_status::ready);
  EXPECT_EQ(how.get(), jobs::kTimeLimit);
  EXPECT_FALSE(waiting.token().stop_requested());
  EXPECT_FALSE(other_given_up);
}

}  // namespace
}  // namespace plico::cli
