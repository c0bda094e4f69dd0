// What every command shares: seed, threads, time limit, where results and talk go, and the report.
// Results go to files or standard output; talk and progress go to standard error only.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/run.h"

namespace plico::cli {

// Exit codes, the same for all commands.
enum ExitCode {
  kDone = 0,         // done and verified
  kNo = 1,           // finished, but the answer is no
  kUsage = 2,        // wrong usage
  kBadInput = 3,     // unusable input
  kFile = 4,         // cannot read or write
  kTimeLimit = 5,    // time limit, best so far written
  kInternal = 70,    // a bug of ours
  kInterrupted = 130  // interrupted, best so far written
};

struct SharedOptions {
  std::vector<std::string> outputs;  // -o, repeatable
  bool force = false, json = false, quiet = false;
  int verbose = 0;
  std::string report_file, progress = "auto";
  std::uint64_t seed = 1;
  int threads = 0;          // 0: all cores
  double time_limit = 0;    // seconds; 0: none
};

class Session {
 public:
  Session(SharedOptions shared, std::string command_line);
  ~Session();

  const SharedOptions& shared() const;
  std::uint64_t seed() const;
  Run run() const;  // stop on Ctrl-C or SIGTERM, deadline from --time-limit, threads, progress

  // Where results go. With no -o the given default path is used. Never overwrites without --force.
  std::vector<std::string> outputs(const std::string& default_path) const;
  void write(const std::string& path, std::string_view bytes);  // remembers the path for the report

  // The report: one JSON object; every option given and every choice made. Printed by --json, written by --report.
  nlohmann::json& report();

  void say(std::string_view line) const;     // one line on standard error unless --quiet
  void warn(std::string_view line) const;
  void print(std::string_view text) const;   // a human result on standard output, unless --json

  // The exit code for an ending: Found 0, Exhausted 1, TimedOut 5, Stopped 130.
  static int exit_code(Ending ending);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plico::cli
