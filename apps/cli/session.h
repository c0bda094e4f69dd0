// What every command shares: seed, threads, time limit, where results and talk go, and the report.
// Results go to files or standard output; talk and progress go to standard error only.
#pragma once
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "parse.h"
#include "plico/base/run.h"

namespace plico::cli {

// Exit codes, the same for all commands.
enum ExitCode {
  kDone = 0,          // done and verified
  kNo = 1,            // finished, but the answer is no
  kUsage = 2,         // wrong usage
  kBadInput = 3,      // unusable input
  kFile = 4,          // cannot read or write
  kTimeLimit = 5,     // time limit, best so far written
  kInternal = 70,     // a bug of ours
  kMemory = 71,       // out of memory
  kInterrupted = 130  // interrupted, best so far written
};

struct SharedOptions {
  std::vector<std::string> outputs;  // -o, repeatable
  bool force = false, json = false, quiet = false;
  int verbose = 0;
  std::string report_file, progress = "auto";
  std::uint64_t seed = 1;
  int threads = 0;        // 0: all cores
  double time_limit = 0;  // seconds; 0: none
};

class Session {
 public:
  // From here on Ctrl-C and SIGTERM ask the run to stop; a second one ends the program at once. The time limit starts.
  // Throws FileError when the report cannot be written.
  Session(SharedOptions shared, std::string command, std::vector<Given> given);
  ~Session();

  const SharedOptions& shared() const;
  std::uint64_t seed() const;  // also remembers that the result depends on it
  Run run() const;             // stop on Ctrl-C or SIGTERM, deadline from --time-limit, threads, progress

  // The bytes of an input ("-" is standard input); its SHA-256 goes into the report.
  std::string read(const std::string& path);

  // Where results go. With no -o the given default path is used, if it is not empty. Call before the work: throws
  // FileError when a file exists (without --force) or its folder does not.
  std::vector<std::string> outputs(const std::string& default_path) const;
  // The same for commands that fill a folder: it is made, and must be empty without --force.
  std::string output_folder(const std::string& default_path) const;
  void write(const std::string& path, std::string_view bytes);  // remembers the path for the report

  // The report: one JSON object. Commands add the figures they report and every choice made; finish() adds version,
  // command line, seed, inputs, outputs, options given, threads, wall time and exit code.
  nlohmann::json& report();
  // What a result file says about its own making (the key plico:report): version, the command that repeats it, seed,
  // inputs with their SHA-256. No wall time and no thread count: the same answer has the same bytes.
  nlohmann::json provenance() const;

  // The command that repeats this run: what was given, the seed, and what `repeat_with` was told.
  std::string repeat_command() const;
  // When a run was cut short by time: the option that makes it end there again, as {"--max-generations", "120"}.
  void repeat_with(const std::string& option, const std::string& value);

  void say(std::string_view line) const;     // one line on standard error unless --quiet
  void detail(std::string_view line) const;  // one line on standard error with --verbose
  void warn(std::string_view line) const;
  void print(std::string_view text) const;  // a human result on standard output, unless results or --json go there

  // Prints and writes the report and the command that repeats the run.
  void finish(int exit_code);

  // The exit code for an ending: Found 0, Exhausted 1, TimedOut 5, Stopped 130.
  static int exit_code(Ending ending);

 private:
  struct State;
  void check_writable(const std::string& path) const;
  bool uses_stdout() const;

  std::unique_ptr<State> state_;
};

}  // namespace plico::cli
