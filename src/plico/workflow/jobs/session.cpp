#include "plico/workflow/jobs/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "plico/base/error.h"
#include "plico/base/sha256.h"
#include "plico/base/version.h"
#include "plico/motion/planner.h"

namespace plico::jobs {
namespace {

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
  std::string job;
  std::vector<Given> given;
  Surroundings surroundings;
  Run::Clock::time_point start = Run::Clock::now();
  double kept_seconds = 0;
  bool seed_used = false;
  std::vector<std::pair<std::string, std::string>> repeat = {};
  std::vector<std::string> written = {};
  nlohmann::json inputs = nlohmann::json::array();
  nlohmann::json report = nlohmann::json::object();

  std::string command_line(bool only_deciding) const;
  void tell(Tone tone, std::string_view text) const {
    if (surroundings.tell) surroundings.tell({tone, std::string(text)});
  }
};

std::string Session::State::command_line(bool only_deciding) const {
  std::string line = "plico " + job;
  bool has_seed = false;
  for (const auto& [option, value] : given) {
    if (only_deciding && decides_nothing(*option)) continue;
    if (std::ranges::any_of(repeat, [&option = option](const auto& r) { return r.first == option->long_name(); }))
      continue;
    if (!repeat.empty() && option->long_name() == "--time-limit") continue;
    has_seed = has_seed || option->long_name() == "--seed";
    if (!option->is_positional()) line += " " + option->names.front();
    if (!option->is_flag()) line += " " + quoted(value);
  }
  for (const auto& [option, value] : repeat) line += fmt::format(" {} {}", option, quoted(value));
  if (seed_used && !has_seed) line += fmt::format(" --seed {}", shared.seed);
  return line;
}

Session::Session(SharedOptions shared, std::string job, std::vector<Given> given, Surroundings surroundings)
    : state_(new State{std::move(shared), std::move(job), std::move(given), std::move(surroundings)}) {
  silence_planners();  // what there is to say is told through `tell`
  if (!state_->shared.report_file.empty())
    state_->surroundings.files.expect_file(state_->shared.report_file, state_->shared.force);
}

Session::~Session() = default;

const SharedOptions& Session::shared() const { return state_->shared; }

std::uint64_t Session::seed() const {
  state_->seed_used = true;
  return state_->shared.seed;
}

Run Session::run() const {
  Run run = state_->surroundings.run;
  run.threads =
      state_->shared.threads > 0 ? state_->shared.threads : int(std::max(1u, std::thread::hardware_concurrency()));
  if (state_->shared.time_limit > 0) {
    const double whole = std::min(state_->shared.time_limit, 1e9);
    const std::chrono::duration<double> limit(whole - std::min(state_->kept_seconds, whole / 4));
    run.deadline = state_->start + std::chrono::duration_cast<Run::Clock::duration>(limit);
  }
  return run;
}

void Session::keep_time(double seconds) { state_->kept_seconds = std::max(state_->kept_seconds, seconds); }

std::string Session::read(const std::string& path) {
  std::string bytes = state_->surroundings.files.read(path);
  state_->inputs.push_back({{"path", path}, {"bytes", bytes.size()}, {"sha256", sha256(bytes)}});
  detail(fmt::format("read {}: {} bytes", path, bytes.size()));
  return bytes;
}

std::vector<std::string> Session::names_in(const std::string& folder) {
  return state_->surroundings.files.names_in(folder);
}

std::vector<std::string> Session::outputs(const std::string& default_path) const {
  std::vector<std::string> paths = state_->shared.outputs;
  if (paths.empty() && !default_path.empty()) paths.push_back(default_path);
  for (const std::string& path : paths) state_->surroundings.files.expect_file(path, state_->shared.force);
  return paths;
}

std::string Session::output_folder(const std::string& default_path) const {
  if (state_->shared.outputs.size() > 1) throw InvalidOption("only one output folder can be given", "give -o once");
  const std::string path = state_->shared.outputs.empty() ? default_path : state_->shared.outputs.front();
  state_->surroundings.files.make_folder(path, !state_->shared.force);
  return path;
}

void Session::make_folder(const std::string& path) const { state_->surroundings.files.make_folder(path, false); }

void Session::write(const std::string& path, std::string_view bytes) {
  state_->surroundings.files.write(path, bytes, state_->shared.force);
  state_->written.push_back(path);
  detail(fmt::format("wrote {}: {} bytes", path, bytes.size()));
}

nlohmann::json& Session::report() { return state_->report; }

nlohmann::json Session::provenance() const {
  nlohmann::json inputs = state_->inputs;
  for (nlohmann::json& input : inputs)
    input["path"] = std::filesystem::path(input["path"].get<std::string>()).filename().string();
  return {{"plico", version()},
          {"command_line", state_->command_line(true)},
          {"seed", state_->shared.seed},
          {"inputs", std::move(inputs)}};
}

std::string Session::repeat_command() const { return state_->command_line(false); }

void Session::repeat_with(const std::string& option, const std::string& value) {
  state_->repeat.emplace_back(option, value);
}

void Session::say(std::string_view line) const { state_->tell(Tone::Line, line); }
void Session::detail(std::string_view line) const { state_->tell(Tone::Detail, line); }
void Session::warn(std::string_view line) const { state_->tell(Tone::Warning, line); }
void Session::print(std::string_view text) const { state_->tell(Tone::Result, text); }

bool Session::worth_repeating() const {
  return state_->seed_used || std::ranges::any_of(state_->written, [](const auto& path) { return path != "-"; });
}

void Session::finish(int exit_code) {
  nlohmann::json& report = state_->report;
  report["plico"] = version();
  report["command"] = state_->job;
  report["command_line"] = repeat_command();
  report["options_given"] = options_given(state_->given);
  report["seed"] = state_->shared.seed;
  report["threads"] = run().threads;
  report["inputs"] = state_->inputs;
  report["outputs"] = state_->written;
  report["exit_code"] = exit_code;
  report["wall_seconds"] = std::chrono::duration<double>(Run::Clock::now() - state_->start).count();
  detail(fmt::format("{:.3g} s with {} threads, seed {}", report["wall_seconds"].get<double>(), run().threads,
                     state_->shared.seed));
  if (!state_->shared.report_file.empty())
    state_->surroundings.files.write(state_->shared.report_file, report.dump(2) + "\n", state_->shared.force);
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

}  // namespace plico::jobs
