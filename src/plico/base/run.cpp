#include "plico/base/run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace plico {

std::string_view name(Ending ending) {
  switch (ending) {
    case Ending::Found:
      return "found";
    case Ending::Exhausted:
      return "exhausted";
    case Ending::TimedOut:
      return "timed-out";
    case Ending::Stopped:
      return "stopped";
  }
  return "unknown";
}

Run limited(const Run& run, double seconds) {
  Run result = run;
  const auto end = Run::Clock::now() + std::chrono::duration_cast<Run::Clock::duration>(
                                           std::chrono::duration<double>(std::min(seconds, 1e9)));
  if (!result.deadline || *result.deadline > end) result.deadline = end;
  return result;
}

void parallel_for(const Run& run, int n, const std::function<void(int)>& body) {
  const int workers = std::clamp(run.threads, 1, std::max(n, 1));
  if (workers == 1) {
    for (int i = 0; i < n; ++i) body(i);
    return;
  }
  std::atomic<int> next{0};
  std::vector<std::exception_ptr> failures(n);
  const auto work = [&] {
    for (int i = next++; i < n; i = next++) {
      try {
        body(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    try {
      for (int t = 1; t < workers; ++t) threads.emplace_back(work);
    } catch (const std::system_error&) {
      // The system gives no more threads: those there are, and this one, do the same work.
    }
    work();
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace plico
