// How a long computation is run: who may stop it, how long it may take, how many threads it may use, who watches.
// A Run never changes a result that is allowed to finish.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>

namespace plico {

// How a search ended: an answer, all tries used, deadline, someone asked.
enum class Ending { Found, Exhausted, TimedOut, Stopped };
std::string_view name(Ending ending);  // "found", "exhausted", "timed-out", "stopped"

// Told about named phases with counts. `total` 0 means unknown. May be called from any thread, one at a time.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void report(std::string_view phase, long done, long total, std::string_view note) = 0;
};

struct Run {
  using Clock = std::chrono::steady_clock;

  std::stop_token stop = {};  // default: nobody can stop it
  std::optional<Clock::time_point> deadline = {};
  int threads = 1;
  Progress* progress = nullptr;  // not owned; null means silent

  bool over() const { return stop.stop_requested() || (deadline && Clock::now() >= *deadline); }
  Ending ending() const { return stop.stop_requested() ? Ending::Stopped : Ending::TimedOut; }  // why it is over
  void report(std::string_view phase, long done, long total = 0, std::string_view note = {}) const {
    if (progress) progress->report(phase, done, total, note);
  }
};

// The same run that must also end `seconds` from now.
Run limited(const Run& run, double seconds);

// Calls body(i) for every i in [0, n) on run.threads threads, in no particular order. An exception of the body is
// rethrown here, the one of the smallest i. Bodies poll `run` themselves when they take long.
void parallel_for(const Run& run, int n, const std::function<void(int)>& body);

}  // namespace plico
