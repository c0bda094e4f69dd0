#include "terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <mutex>

#include "failure.h"
#include "highlight.h"
#include "progress.h"

namespace plico::cli {

namespace {

// What is said twice over is a line for each phase, where nothing else was asked for.
std::string progress_style(const jobs::SharedOptions& shared) {
  if (shared.quiet) return "none";
  return shared.verbose >= 2 && shared.progress == "auto" ? "phases" : shared.progress;
}

}  // namespace

// The files of this computer. What is being written is let end, and a folder made for nothing goes again.
class Terminal::Files final : public jobs::JobFiles {
 public:
  explicit Files(Terminal& terminal) : terminal_(terminal) {}

  std::string read(const std::string& path) override { return disk_.read(path); }
  std::vector<std::string> names_in(const std::string& folder) override { return disk_.names_in(folder); }
  void expect_file(const std::string& path, bool overwrite) override { disk_.expect_file(path, overwrite); }
  void make_folder(const std::string& path, bool must_be_empty) override {
    std::error_code error;
    const bool is_new = !std::filesystem::exists(path, error);
    disk_.make_folder(path, must_be_empty);
    const std::lock_guard lock(mutex_);
    if (is_new) made_.push_back(path);
  }
  void write(const std::string& path, std::string_view bytes, bool overwrite) override {
    terminal_.signal_.let_end();
    disk_.write(path, bytes, overwrite);
  }

  void remove_empty_folders() {
    std::error_code error;
    const std::lock_guard lock(mutex_);
    for (const std::string& folder : made_) std::filesystem::remove(folder, error);  // of empty ones only
  }

 private:
  Terminal& terminal_;
  jobs::DiskFiles disk_;
  std::mutex mutex_;
  std::vector<std::string> made_;
};

Terminal::Terminal(jobs::SharedOptions shared)
    : shared_(std::move(shared)),
      files_(std::make_unique<Files>(*this)),
      progress_(make_progress(progress_style(shared_))),
      signal_(shared_.time_limit, [this](jobs::ExitCode exit_code) { give_up(exit_code); }) {}

Terminal::~Terminal() = default;

jobs::JobFiles& Terminal::files() { return *files_; }

Run Terminal::run() const {
  Run run;
  run.stop = signal_.token();
  run.progress = progress_.get();
  return run;
}

bool Terminal::uses_stdout() const {
  return shared_.json || shared_.report_file == "-" || std::ranges::find(shared_.outputs, "-") != shared_.outputs.end();
}

void Terminal::tell(const jobs::Message& message) const {
  if (shared_.quiet || (message.tone == jobs::Tone::Detail && shared_.verbose == 0)) return;
  if (message.tone == jobs::Tone::Result && uses_stdout() && shared_.json) return;
  if (progress_) progress_->erase();
  switch (message.tone) {
    case jobs::Tone::Result:
      fmt::print(uses_stdout() ? stderr : stdout, "{}", message.text);
      return;
    case jobs::Tone::Detail:
    case jobs::Tone::Line:
      fmt::print(stderr, "{}\n", message.text);
      return;
    case jobs::Tone::Warning:
      fmt::print(stderr, "plico: {} {}\n", highlighted("warning:", Highlight::Warning), message.text);
      return;
  }
}

void Terminal::end_work() {
  signal_.let_end();
  progress_.reset();
}

void Terminal::give_up(jobs::ExitCode exit_code) {
  files_->remove_empty_folders();
  if (progress_) progress_->erase();
  Failure failure;
  failure.exit_code = exit_code;
  failure.code = exit_code == jobs::kTimeLimit ? "run/time-limit" : "run/stopped";
  failure.message = exit_code == jobs::kTimeLimit
                        ? "the time limit passed before there was a result; nothing is written"
                        : "stopped before there was a result; nothing is written";
  failure.suggestion = "allow more time, or take a smaller mesh: plico simplify";
  cli::tell(failure, shared_.json);
  std::fflush(stdout);
  _exit(exit_code);
}

}  // namespace plico::cli
