#include "stop_signal.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

namespace plico::cli {
namespace {

using Clock = Run::Clock;
using std::chrono::duration;

// timeout(1) and terminals signal the process and its whole group: one wish to stop may arrive twice.
constexpr std::chrono::milliseconds kEcho(200);

// The build for sanitizers runs twenty times slower; it looks for other faults than slowness.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PLICO_SANITIZED 1
#endif
#endif
#ifdef PLICO_SANITIZED
constexpr double kSlowness = 30;
#else
constexpr double kSlowness = 1;
#endif
constexpr double kGrace = 0.9 * kSlowness;     // seconds, so that the program has ended within one
constexpr double kLongest = 8 * kSlowness;     // where others have the processor
constexpr double kIdle = 0.9, kLittle = 5e-3;  // less work than this in that time: it waits, for input or a pipe,
                                               // unless a thread wants a processor and gets none
constexpr std::chrono::milliseconds kTick(20);

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// All threads but this one, which only watches.
double seconds_of_others() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID) - seconds_of(CLOCK_THREAD_CPUTIME_ID); }

// Is there a thread besides this one that runs or could run? Linux tells; elsewhere no. Source: proc(5), field "state".
bool others_want_processor() {
  std::error_code none;
  const std::string own = std::to_string(gettid());
  std::filesystem::directory_iterator thread("/proc/self/task", none);
  for (; !none && thread != std::filesystem::directory_iterator(); thread.increment(none)) {
    if (thread->path().filename() == own) continue;
    std::string stat;
    std::getline(std::ifstream(thread->path() / "stat"), stat);
    const std::size_t name_ends = stat.rfind(')');
    if (name_ends != std::string::npos && stat.compare(name_ends, 3, ") R") == 0) return true;
  }
  return false;
}

sigset_t stopping_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

// A second of an idle computer: on a loaded one the work gets as much time of the processor as it would have had.
class StopSignal::Grace {
 public:
  explicit Grace(jobs::ExitCode because) : because_(because) {}

  jobs::ExitCode because() const { return because_; }

  // To be asked often, since it sees by that whether the work goes on.
  bool is_over() {
    const Clock::time_point now = Clock::now();
    const double worked = seconds_of_others();
    if (worked - worked_when_busy_ > kLittle) busy_ = now, worked_when_busy_ = worked;
    const double passed = duration<double>(now - begin_).count(), idle = duration<double>(now - busy_).count();
    return (idle > kIdle && !others_want_processor()) ||
           (passed > kGrace && (worked - worked_before_ > kGrace || passed > kLongest));
  }

 private:
  jobs::ExitCode because_;
  Clock::time_point begin_ = Clock::now(), busy_ = begin_;
  double worked_before_ = seconds_of_others(), worked_when_busy_ = worked_before_;
};

StopSignal::StopSignal(double time_limit, std::function<void(jobs::ExitCode)> give_up) : give_up_(std::move(give_up)) {
  if (time_limit > 0)
    limit_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(duration<double>(std::min(time_limit, 1e9)));
  // A thread that waits for signals may take locks, which a signal handler must not.
  const sigset_t set = stopping_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  watcher_ = std::thread([this] { watch(); });
}

StopSignal::~StopSignal() {
  closing_ = true;
  pthread_kill(watcher_.native_handle(), SIGTERM);  // wakes the watcher
  watcher_.join();
}

void StopSignal::let_end() {
  State working = State::Working;
  if (state_.compare_exchange_strong(working, State::Ending) || working == State::Ending) return;
  for (;;) pause();  // given up: the program is about to end, and nothing more may be written
}

void StopSignal::watch() {
  const sigset_t set = stopping_signals();
  const timespec tick{0, std::chrono::nanoseconds(kTick).count()};
  while (!closing_) {
    const bool on_the_clock = limit_ || grace_;
    const int signal = sigtimedwait(&set, nullptr, on_the_clock ? &tick : nullptr);
    if (closing_) return;
    if (signal > 0) take_signal();
    look_at_the_clock();
  }
}

void StopSignal::take_signal() {
  if (source_.stop_requested()) {
    if (Clock::now() - asked_ > kEcho) _exit(jobs::kInterrupted);
    return;
  }
  asked_ = Clock::now();
  source_.request_stop();
  grace_ = std::make_unique<Grace>(jobs::kInterrupted);
}

void StopSignal::look_at_the_clock() {
  if (!grace_ && limit_ && Clock::now() > *limit_) grace_ = std::make_unique<Grace>(jobs::kTimeLimit);
  if (!grace_ || !give_up_ || !grace_->is_over()) return;
  State working = State::Working;
  if (state_.compare_exchange_strong(working, State::GivenUp)) give_up_(grace_->because());
}

}  // namespace plico::cli
