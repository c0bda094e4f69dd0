#include "program.h"

#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "help.h"
#include "parse.h"
#include "plico/base/error.h"
#include "plico/base/version.h"
#include "session.h"
#include "shared_options.h"
#include "suggest.h"

namespace plico::cli {
namespace {

// A failure as it is told to people and, with --json, to programs.
struct Failure {
  ExitCode exit_code = kInternal;
  std::string code, message, where, suggestion;
};

Failure failure_of(const Error& error, ExitCode exit_code) {
  return {exit_code, error.code(), error.what(), error.where(), error.suggestion()};
}

// The exception that is being handled, as a failure.
Failure current_failure() {
  try {
    throw;
  } catch (const InvalidOption& error) {
    return failure_of(error, kUsage);
  } catch (const InvalidInput& error) {
    return failure_of(error, kBadInput);
  } catch (const FileError& error) {
    return failure_of(error, kFile);
  } catch (const std::bad_alloc&) {
    return {kInternal, "internal/memory", "not enough memory", {}, {}};
  } catch (const std::exception& error) {
    return {kInternal, "internal/bug", error.what(), {}, "report this with the command line and the input"};
  }
}

void tell(const Failure& failure, bool json) {
  std::fprintf(stderr, "plico: %s: %s\n", failure.code.c_str(), failure.message.c_str());
  if (!failure.where.empty()) std::fprintf(stderr, "  where: %s\n", failure.where.c_str());
  if (!failure.suggestion.empty()) std::fprintf(stderr, "  try:   %s\n", failure.suggestion.c_str());
  if (!json) return;
  const nlohmann::json error = {{"code", failure.code},
                                {"message", failure.message},
                                {"where", failure.where},
                                {"suggestion", failure.suggestion}};
  std::puts(nlohmann::json({{"error", error}, {"exit_code", failure.exit_code}}).dump().c_str());
}

int fail(bool json) {
  const Failure failure = current_failure();
  tell(failure, json);
  return failure.exit_code;
}

void print(const std::string& text, std::FILE* to = stdout) { std::fwrite(text.data(), 1, text.size(), to); }

bool asks(const std::vector<std::string>& words, const std::string& question) {
  for (const std::string& word : words) {
    if (word == question) return true;
    if (word == "--") return false;
  }
  return false;
}

// The command that the first words name ("info", "origami info") and how many words that takes; throws when none does.
std::pair<const Command*, int> find_command(const std::vector<Command>& commands,
                                            const std::vector<std::string>& words) {
  for (int taken = 2; taken >= 1; --taken) {
    if (taken > static_cast<int>(words.size())) continue;
    const std::string name = taken == 2 ? words[0] + " " + words[1] : words[0];
    for (const Command& command : commands)
      if (command.name == name) return {&command, taken};
  }
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  const std::string nearest = nearest_word(words[0], names);
  throw InvalidOption(fmt::format("'{}' is not a command of plico{}", words[0], did_you_mean(nearest)), "plico --help");
}

int run_command(const Command& command, const std::vector<std::string>& words) {
  SharedOptions shared;
  bool json = asks(words, "--json");
  try {
    const std::vector<Option> table = with_shared_options(command, shared);
    std::vector<Given> given = parse(command, table, words);
    json = shared.json;
    check(shared);
    Session session(shared, command.name, std::move(given));
    const int exit_code = command.run(session);
    session.finish(exit_code);
    return exit_code;
  } catch (...) {
    return fail(json);
  }
}

}  // namespace

int run_program(const std::vector<std::string>& words) {
  const std::vector<Command> commands = all_commands();
  if (words.empty()) {
    print(program_help(commands), stderr);
    return kUsage;
  }
  if (words[0] == "--version") {
    print("plico " + version() + "\n");
    return kDone;
  }
  try {
    const bool wants_help = words[0] == "help" || asks(words, "--help") || asks(words, "-h");
    std::vector<std::string> rest = words;
    if (wants_help && (words[0] == "help" || words[0] == "--help" || words[0] == "-h")) rest.erase(rest.begin());
    if (rest.empty()) {
      print(program_help(commands));
      return kDone;
    }
    const auto [command, taken] = find_command(commands, rest);
    if (wants_help) {
      print(command_help(*command));
      return kDone;
    }
    return run_command(*command, {rest.begin() + taken, rest.end()});
  } catch (...) {
    return fail(asks(words, "--json"));
  }
}

}  // namespace plico::cli
