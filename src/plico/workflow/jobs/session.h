// What a running job has: its options, its files, its limits, whom it tells what, and the report it fills.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/job_files.h"

namespace plico::jobs {

/// How a job ended, the same for all jobs; the exit code of its command.
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

/// The options of every job; those about talk (json, quiet, verbose, progress) are the terminal's affair.
struct SharedOptions {
  std::vector<std::string> outputs;  // -o, repeatable
  bool force = false, json = false, quiet = false;
  int verbose = 0;
  std::string report_file, progress = "auto";
  std::uint64_t seed = 1;
  int threads = 0;        // 0: all cores
  double time_limit = 0;  // seconds; 0: none
};

/// What a job tells while it runs. A result is text for people, line breaks included; all else is one line.
enum class Tone { Result, Line, Detail, Warning };
struct Message {
  Tone tone = Tone::Line;
  std::string text;
};

/// Where a job runs: a terminal, a page in a browser, a program of one's own.
struct Surroundings {
  JobFiles& files;
  std::function<void(const Message&)> tell;  // may be empty
  Run run;                                   // who may stop it and who watches; deadline and threads come from options
};

class Session {
 public:
  /// The time limit starts. Throws FileError when the report could not be written.
  Session(SharedOptions shared, std::string job, std::vector<Given> given, Surroundings surroundings);
  ~Session();

  const SharedOptions& shared() const;
  std::uint64_t seed() const;  // also remembers that the result depends on it
  Run run() const;             // of the surroundings, with the deadline of --time-limit and the threads of --threads
  /// What comes after the search (judging, writing) takes this long: the deadline is earlier by it, a quarter of the
  /// time limit at most.
  void keep_time(double seconds);

  /// The bytes of an input ("-" is standard input); its SHA-256 goes into the report.
  std::string read(const std::string& path);
  std::vector<std::string> names_in(const std::string& folder);

  /// Where results go. With no -o the given default path is used, if it is not empty. Call before the work: throws
  /// FileError when a file exists (without --force) or its folder does not.
  std::vector<std::string> outputs(const std::string& default_path) const;
  /// The same for jobs that fill a folder: it is made, and must be empty without --force.
  std::string output_folder(const std::string& default_path) const;
  void make_folder(const std::string& path) const;              // one that may hold something
  void write(const std::string& path, std::string_view bytes);  // remembers the path for the report

  /// The report: one JSON object. Jobs add the figures they report and every choice made; finish() adds version,
  /// command line, seed, inputs, outputs, options given, threads, wall time and exit code.
  nlohmann::json& report();
  /// What a result file says about its own making (the key plico:report): version, the command that repeats it, seed,
  /// inputs with their SHA-256. No wall time and no thread count: the same answer has the same bytes.
  nlohmann::json provenance() const;

  /// The command that repeats this run: what was given, the seed, and what `repeat_with` was told.
  std::string repeat_command() const;
  /// When a run was cut short by time: the option that makes it end there again, as {"--max-generations", "120"}.
  void repeat_with(const std::string& option, const std::string& value);

  void say(std::string_view line) const;
  void detail(std::string_view line) const;  // for those who want to hear more
  void warn(std::string_view line) const;
  void print(std::string_view text) const;  // the result for people

  /// Completes the report and writes it where --report says.
  void finish(int exit_code);
  bool worth_repeating() const;  // something was written, or drawn by lot

  /// The exit code for an ending: Found 0, Exhausted 1, TimedOut 5, Stopped 130.
  static int exit_code(Ending ending);

 private:
  struct State;

  std::unique_ptr<State> state_;
};

}  // namespace plico::jobs
