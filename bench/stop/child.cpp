#include "child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <regex>
#include <thread>

namespace plico::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr const char* kErrors = "stderr.txt";

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

[[noreturn]] void become(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (chdir(folder.c_str()) != 0) _exit(126);
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  dup2(open(kErrors, O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

double worked(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double in_seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * double(time.tv_usec); }

bool has_ended(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

// Lines as "    0.18 s  untangling panels".
std::vector<Phase> phases_in(const std::filesystem::path& file) {
  static const std::regex line_of_phase(R"( *([0-9.]+) s  (.+))");
  std::vector<Phase> phases;
  std::ifstream in(file);
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, match, line_of_phase)) phases.push_back({match[2], std::stod(match[1])});
  return phases;
}

}  // namespace

Ended run_and_interrupt(const std::vector<std::string>& words, const std::filesystem::path& folder, double moment) {
  Ended result;
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child == 0) become(words, folder);
  while (!has_ended(child) && (moment <= 0 || seconds_since(start) < moment))
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  result.asked = !has_ended(child);
  const Clock::time_point asked = Clock::now();
  const double worked_before = worked(child);
  if (result.asked) kill(child, SIGINT);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  result.lived = seconds_since(start);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (result.asked) {
    result.wait = seconds_since(asked);
    result.work = in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime) - worked_before;
  }
  result.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  result.phases = phases_in(folder / kErrors);
  return result;
}

}  // namespace plico::bench
