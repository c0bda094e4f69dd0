// Ctrl-C and SIGTERM as a stop token.
#pragma once
#include <atomic>
#include <stop_token>
#include <thread>

namespace plico::cli {

// While it lives, the first SIGINT or SIGTERM asks to stop and a second one, later than an echo of the first, ends the
// program with exit code 130. Make it before any other thread: they inherit that these signals are not theirs.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  void wait_for_signals();

  std::stop_source source_;
  std::atomic<bool> closing_{false};
  std::thread waiter_;
};

}  // namespace plico::cli
