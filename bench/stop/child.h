// A program that is run, asked to stop at a moment, and watched until it has ended.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plico::bench {

struct Phase {
  std::string name;
  double begin = 0;  // seconds since the program began
};

struct Ended {
  int exit_code = 0;          // 128 + the signal when it was killed
  double lived = 0;           // seconds
  double wait = 0;            // seconds it went on after it was asked
  double work = 0;            // of the processor, in that time
  double peak_mb = 0;         // most memory it had
  bool asked = false;         // it had not ended by itself before
  std::vector<Phase> phases;  // in which it was, as -vv tells them
};

/// Runs `words` (the program first) in `folder` and sends SIGINT after `moment` seconds; never when that is 0.
/// Standard error goes to the file stderr.txt there.
Ended run_and_interrupt(const std::vector<std::string>& words, const std::filesystem::path& folder, double moment);

}  // namespace plico::bench
