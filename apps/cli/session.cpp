#include "session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "plico/base/error.h"
#include "plico/base/sha256.h"
#include "plico/base/version.h"
#include "plico/io/text/file.h"
#include "progress.h"
#include "stop_signal.h"

namespace plico::cli {
namespace {

namespace fs = std::filesystem;

// A word as a shell reads it back.
std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) || c > 127 ||
           std::string_view("-_./:,=+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

// Options that change what is said, how fast, or where to, but not the answer: not part of a result file.
bool decides_nothing(const Option& option) {
  constexpr std::string_view kTalk[] = {"--output", "--force",   "--json",    "--report",    "--progress",
                                        "--quiet",  "--verbose", "--threads", "--time-limit"};
  return std::ranges::find(kTalk, option.long_name()) != std::end(kTalk);
}

nlohmann::json options_given(const std::vector<Given>& given) {
  nlohmann::json options = nlohmann::json::object();
  for (const auto& [option, value] : given) {
    const std::string& name = option->long_name();
    const std::string key = option->is_positional() ? name : name.substr(name.find_first_not_of('-'));
    if (option->repeatable)
      options[key].push_back(value);
    else
      options[key] = value;
  }
  return options;
}

}  // namespace

struct Session::State {
  SharedOptions shared;
  std::string command;
  std::vector<Given> given;
  Run::Clock::time_point start = Run::Clock::now();
  StopSignal signal;
  std::unique_ptr<Progress> progress;
  bool seed_used = false;
  std::vector<std::pair<std::string, std::string>> repeat;
  std::vector<std::string> written;
  nlohmann::json inputs = nlohmann::json::array();
  nlohmann::json report = nlohmann::json::object();

  std::string command_line(bool only_deciding) const;
};

std::string Session::State::command_line(bool only_deciding) const {
  std::string line = "plico " + command;
  bool has_seed = false;
  for (const auto& [option, value] : given) {
    if (only_deciding && decides_nothing(*option)) continue;
    if (std::ranges::any_of(repeat, [&](const auto& r) { return r.first == option->long_name(); })) continue;
    if (!repeat.empty() && option->long_name() == "--time-limit") continue;
    has_seed = has_seed || option->long_name() == "--seed";
    if (!option->is_positional()) line += " " + option->names.front();
    if (!option->is_flag()) line += " " + quoted(value);
  }
  for (const auto& [option, value] : repeat) line += fmt::format(" {} {}", option, quoted(value));
  if (seed_used && !has_seed) line += fmt::format(" --seed {}", shared.seed);
  return line;
}

Session::Session(SharedOptions shared, std::string command, std::vector<Given> given)
    : state_(std::make_unique<State>()) {
  state_->shared = std::move(shared);
  state_->command = std::move(command);
  state_->given = std::move(given);
  state_->progress = make_progress(state_->shared.quiet ? "none" : state_->shared.progress);
  if (!state_->shared.report_file.empty()) check_writable(state_->shared.report_file);
}

Session::~Session() = default;

const SharedOptions& Session::shared() const { return state_->shared; }

std::uint64_t Session::seed() const {
  state_->seed_used = true;
  return state_->shared.seed;
}

Run Session::run() const {
  Run run;
  run.stop = state_->signal.token();
  run.threads =
      state_->shared.threads > 0 ? state_->shared.threads : int(std::max(1u, std::thread::hardware_concurrency()));
  run.progress = state_->progress.get();
  if (state_->shared.time_limit > 0) {
    const std::chrono::duration<double> limit(std::min(state_->shared.time_limit, 1e9));
    run.deadline = state_->start + std::chrono::duration_cast<Run::Clock::duration>(limit);
  }
  return run;
}

std::string Session::read(const std::string& path) {
  std::string bytes = read_file(path);
  state_->inputs.push_back({{"path", path}, {"bytes", bytes.size()}, {"sha256", sha256(bytes)}});
  return bytes;
}

void Session::check_writable(const std::string& path) const {
  if (path == "-") return;
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw FileError("file/no-folder", fmt::format("cannot write {}: there is no folder {}", path, folder.string()),
                    path, fmt::format("mkdir -p {}", quoted(folder.string())));
  if (fs::is_directory(path, error))
    throw FileError("file/write", fmt::format("cannot write {}: it is a folder", path), path);
  if (!state_->shared.force && fs::exists(path, error))
    throw FileError("file/exists", fmt::format("{} exists already", path), path, "add --force to overwrite it");
}

std::vector<std::string> Session::outputs(const std::string& default_path) const {
  std::vector<std::string> paths = state_->shared.outputs;
  if (paths.empty() && !default_path.empty()) paths.push_back(default_path);
  for (const std::string& path : paths) check_writable(path);
  return paths;
}

std::string Session::output_folder(const std::string& default_path) const {
  if (state_->shared.outputs.size() > 1) throw InvalidOption("only one output folder can be given", "give -o once");
  const std::string path = state_->shared.outputs.empty() ? default_path : state_->shared.outputs.front();
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw FileError("file/not-a-folder", fmt::format("{} is not a folder", path), path);
  if (!state_->shared.force && fs::is_directory(path, error) && !fs::is_empty(path, error))
    throw FileError("file/exists", fmt::format("the folder {} is not empty", path), path,
                    "add --force to overwrite the files in it");
  fs::create_directories(path, error);
  if (error) throw FileError("file/write", fmt::format("cannot make the folder {}: {}", path, error.message()), path);
  return path;
}

void Session::write(const std::string& path, std::string_view bytes) {
  write_file(path, bytes, state_->shared.force);
  state_->written.push_back(path);
}

nlohmann::json& Session::report() { return state_->report; }

nlohmann::json Session::provenance() const {
  nlohmann::json inputs = state_->inputs;
  for (nlohmann::json& input : inputs) input["path"] = fs::path(input["path"].get<std::string>()).filename().string();
  return {{"plico", version()},
          {"command_line", state_->command_line(true)},
          {"seed", state_->shared.seed},
          {"inputs", std::move(inputs)}};
}

std::string Session::repeat_command() const { return state_->command_line(false); }

void Session::repeat_with(const std::string& option, const std::string& value) {
  state_->repeat.emplace_back(option, value);
}

void Session::say(std::string_view line) const {
  if (!state_->shared.quiet) fmt::print(stderr, "{}\n", line);
}

void Session::detail(std::string_view line) const {
  if (state_->shared.verbose > 0) fmt::print(stderr, "{}\n", line);
}

void Session::warn(std::string_view line) const { say(fmt::format("plico: warning: {}", line)); }

bool Session::uses_stdout() const {
  const SharedOptions& shared = state_->shared;
  return shared.json || shared.report_file == "-" || std::ranges::find(shared.outputs, "-") != shared.outputs.end();
}

void Session::print(std::string_view text) const {
  if (!uses_stdout())
    fmt::print(stdout, "{}", text);
  else if (!state_->shared.json && !state_->shared.quiet)
    fmt::print(stderr, "{}", text);
}

void Session::finish(int exit_code) {
  state_->progress.reset();
  const bool worth_repeating =
      state_->seed_used || std::ranges::any_of(state_->written, [](const auto& path) { return path != "-"; });
  nlohmann::json& report = state_->report;
  report["plico"] = version();
  report["command"] = state_->command;
  report["command_line"] = repeat_command();
  report["options_given"] = options_given(state_->given);
  report["seed"] = state_->shared.seed;
  report["threads"] = run().threads;
  report["inputs"] = state_->inputs;
  report["outputs"] = state_->written;
  report["exit_code"] = exit_code;
  report["wall_seconds"] = std::chrono::duration<double>(Run::Clock::now() - state_->start).count();
  const std::string text = report.dump(2) + "\n";
  if (!state_->shared.report_file.empty()) write_file(state_->shared.report_file, text, state_->shared.force);
  if (state_->shared.json) fmt::print(stdout, "{}", text);
  if (worth_repeating) say(repeat_command());
}

int Session::exit_code(Ending ending) {
  switch (ending) {
    case Ending::Found:
      return kDone;
    case Ending::Exhausted:
      return kNo;
    case Ending::TimedOut:
      return kTimeLimit;
    case Ending::Stopped:
      return kInterrupted;
  }
  return kInternal;
}

}  // namespace plico::cli
