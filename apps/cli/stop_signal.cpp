#include "stop_signal.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>

namespace plico::cli {
namespace {

using Clock = std::chrono::steady_clock;

// timeout(1) and terminals signal the process and its whole group: one wish to stop may arrive twice.
constexpr std::chrono::milliseconds kEcho(200);

sigset_t stopping_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

StopSignal::StopSignal() {
  // A thread that waits for signals may take locks, which a signal handler must not.
  const sigset_t set = stopping_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::thread([this] { wait_for_signals(); });
}

StopSignal::~StopSignal() {
  closing_ = true;
  pthread_kill(waiter_.native_handle(), SIGTERM);  // wakes the waiter
  waiter_.join();
}

void StopSignal::wait_for_signals() {
  const sigset_t set = stopping_signals();
  Clock::time_point asked{};
  for (int signal = 0; sigwait(&set, &signal) == 0;) {
    if (closing_) return;
    if (!source_.stop_requested()) {
      asked = Clock::now();
      source_.request_stop();
    } else if (Clock::now() - asked > kEcho) {
      _exit(130);
    }
  }
}

}  // namespace plico::cli
