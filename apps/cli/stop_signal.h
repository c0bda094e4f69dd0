// Ctrl-C, SIGTERM and the time limit: whoever is asked to stop has a second to write the best there is.
#pragma once
#include <atomic>
#include <functional>
#include <optional>
#include <stop_token>
#include <thread>

#include "plico/workflow/jobs/session.h"

namespace plico::cli {

// While it lives, the first SIGINT or SIGTERM asks to stop and a second one, later than an echo of the first, ends the
// program with exit code 130. Work that goes on for more than a second after it was asked to stop, or after its time
// limit, is given up. Make it before any other thread: they inherit that these signals are not theirs.
class StopSignal {
 public:
  // `time_limit` in seconds, 0 for none. `give_up` is called on another thread, at most once, with the exit code, and
  // ends the program; empty: nothing is given up.
  explicit StopSignal(double time_limit = 0, std::function<void(jobs::ExitCode)> give_up = {});
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  std::stop_token token() const { return source_.get_token(); }

  // A result is being written, or the work is done: nothing is given up any more.
  void let_end();

 private:
  enum class State { Working, Ending, GivenUp };
  class Grace;

  void watch();
  void take(int signal);
  void look_at_the_clock();

  std::function<void(jobs::ExitCode)> give_up_;
  std::optional<Run::Clock::time_point> limit_;
  Run::Clock::time_point asked_{};
  std::unique_ptr<Grace> grace_;  // the watcher's own
  std::stop_source source_;
  std::atomic<State> state_{State::Working};
  std::atomic<bool> closing_{false};
  std::thread watcher_;
};

}  // namespace plico::cli
