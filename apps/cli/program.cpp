#include "program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>

#include "failure.h"
#include "help.h"
#include "parse.h"
#include "plico/base/error.h"
#include "plico/base/version.h"
#include "plico/workflow/jobs/shared_options.h"
#include "plico/workflow/jobs/suggest.h"
#include "terminal.h"

namespace plico::cli {
namespace {

using jobs::did_you_mean;
using jobs::kDone, jobs::kUsage;
using jobs::nearest_word;
using jobs::Session;
using jobs::SharedOptions;

int fail(bool json, const jobs::Attempt& attempt = {}) {
  const Failure failure = current_failure(attempt);
  tell(failure, json);
  return failure.exit_code;
}

void print(const std::string& text, std::FILE* to = stdout) { std::fwrite(text.data(), 1, text.size(), to); }

// What was printed may still wait, and have no place to go.
void expect_all_printed() {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
  throw FileError("file/write", fmt::format("cannot write standard output: {}", std::strerror(errno)),
                  "standard output", "df -h shows what is full");
}

std::string first_file(const std::vector<jobs::Given>& given) {
  const auto at = std::ranges::find_if(given, [](const jobs::Given& one) { return one.option->is_positional(); });
  return at == given.end() ? "" : at->value;
}

bool asks(const std::vector<std::string>& words, const std::string& question) {
  for (const std::string& word : words) {
    if (word == question) return true;
    if (word == "--") return false;
  }
  return false;
}

// The commands whose first of two words is `group`.
std::vector<Job> members(const std::vector<Job>& commands, const std::string& group) {
  std::vector<Job> result;
  std::ranges::copy_if(commands, std::back_inserter(result),
                       [&](const Job& command) { return command.name.starts_with(group + " "); });
  return result;
}

[[noreturn]] void refuse_unknown(const std::vector<Job>& commands, const std::vector<std::string>& words) {
  std::vector<std::string> names, seconds;
  for (const Job& command : commands) names.push_back(command.name);
  for (const Job& command : members(commands, words[0])) seconds.push_back(command.name.substr(words[0].size() + 1));
  if (seconds.empty())
    throw InvalidOption(
        fmt::format("'{}' is not a command of plico{}", words[0], did_you_mean(nearest_word(words[0], names))),
        "plico --help");
  const std::string nearest = words.size() > 1 ? nearest_word(words[1], seconds) : "";
  throw InvalidOption(
      fmt::format("plico {} needs one of: {}{}", words[0], fmt::join(seconds, ", "), did_you_mean(nearest)),
      fmt::format("plico {} --help", words[0]));
}

// The command that the first words name ("info", "origami info") and how many words that takes; null when none does.
std::pair<const Job*, int> find_command(const std::vector<Job>& commands, const std::vector<std::string>& words) {
  for (int taken = std::min<int>(2, static_cast<int>(words.size())); taken >= 1; --taken) {
    const std::string name = taken == 2 ? words[0] + " " + words[1] : words[0];
    for (const Job& command : commands)
      if (command.name == name) return {&command, taken};
  }
  return {nullptr, 0};
}

bool is_help(const std::string& word) { return word == "help" || word == "--help" || word == "-h"; }

// `words` name what help is wanted for: nothing, a command, or a group of commands.
std::string help_for(const std::vector<Job>& commands, std::vector<std::string> words) {
  if (is_help(words[0])) words.erase(words.begin());
  if (words.empty()) return program_help(commands);
  if (const Job* command = find_command(commands, words).first) return command_help(*command);
  if (const std::vector<Job> group = members(commands, words[0]); !group.empty()) return group_help(group);
  refuse_unknown(commands, words);
}

int run_session(Session& session, const Job& job, Terminal& terminal, const SharedOptions& shared) {
  const int exit_code = job.run(session);
  terminal.end_work();
  session.finish(exit_code);
  if (shared.json) print(session.report().dump(2) + "\n");
  expect_all_printed();
  if (session.worth_repeating()) session.say(session.repeat_command());
  return exit_code;
}

int run_command(const Job& job, const std::vector<std::string>& words) {
  SharedOptions shared;
  bool json = asks(words, "--json");
  jobs::Attempt attempt{.job = job.name, .input = {}};
  try {
    const std::vector<Option> table = with_shared_options(job, shared);
    std::vector<Given> given = parse(job, table, words);
    json = shared.json;
    attempt.input = first_file(given);
    check(shared);
    Terminal terminal(shared);
    const auto tell = [&](const jobs::Message& message) { terminal.tell(message); };
    Session session(shared, job.name, std::move(given), {terminal.files(), tell, terminal.run()});
    return run_session(session, job, terminal, shared);
  } catch (...) {
    return fail(json, attempt);
  }
}

}  // namespace

int run_program(const std::vector<Job>& commands, const std::vector<std::string>& words) {
  if (words.empty()) {
    print(program_help(commands), stderr);
    return kUsage;
  }
  try {
    if (words[0] == "--version") {
      print("plico " + version() + "\n");
      expect_all_printed();
      return kDone;
    }
    if (is_help(words[0]) || asks(words, "--help") || asks(words, "-h")) {
      print(help_for(commands, words));
      expect_all_printed();
      return kDone;
    }
    const auto [command, taken] = find_command(commands, words);
    if (!command) refuse_unknown(commands, words);
    return run_command(*command, {words.begin() + taken, words.end()});
  } catch (...) {
    return fail(asks(words, "--json"));
  }
}

}  // namespace plico::cli
