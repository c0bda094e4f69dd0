#include "help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "plico/base/version.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/shared_options.h"

namespace plico::cli {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;
constexpr std::size_t kLine = 100, kMaxLeft = 30;

std::string two_columns(const Rows& rows) {
  std::size_t width = 0;
  for (const auto& [left, right] : rows)
    if (left.size() <= kMaxLeft) width = std::max(width, left.size());
  const std::size_t indent = 2 + width + 2;
  std::string text;
  for (const auto& [left, right] : rows) {
    text += "  " + left;
    text += left.size() <= width ? std::string(width - left.size() + 2, ' ') : "\n" + std::string(indent, ' ');
    text += wrapped(right, indent, kLine) + "\n";
  }
  return text;
}

// A command line is copied whole, so it is never broken; what it does stands above it.
std::string example_lines(const Rows& examples) {
  std::string text = "Examples:\n";
  for (const auto& [line, what] : examples) text += fmt::format("  # {}\n  {}\n", what, line);
  return text;
}

std::string section(const std::string& title, const std::vector<Option>& options, bool positionals) {
  Rows rows;
  for (const Option& option : options)
    if (option.is_positional() == positionals) rows.emplace_back(shown_name(option), full_help(option));
  return rows.empty() ? "" : "\n" + title + ":\n" + two_columns(rows);
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string result;
  std::size_t column = indent, begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (column > indent && column + 1 + length > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += text.substr(begin, length);
    column += length;
    begin = end + 1;
  }
  return result;
}

std::string shown_name(const Option& option) {
  if (option.is_positional()) return upper(option.names.front()) + (option.repeatable ? "..." : "");
  std::string text = option.names.front();
  if (option.names.size() == 1 && text.starts_with("--")) text = "    " + text;  // under the long names
  for (std::size_t i = 1; i < option.names.size(); ++i) text += ", " + option.names[i];
  return option.value.empty() ? text : text + " " + option.value;
}

std::string full_help(const Option& option) {
  std::string text = option.help;
  if (!option.choices.empty()) text += fmt::format(": {}", fmt::join(option.choices, ", "));
  if (option.range.is_bounded()) text += fmt::format(", {}", option.range.in_words());
  if (!option.shown_default.empty()) text += fmt::format(" (default {})", option.shown_default);
  if (option.repeatable && !option.is_positional() && !option.is_flag()) text += " (may be repeated)";
  return text;
}

std::string usage_line(const Job& command) {
  std::string text = "plico " + command.name + " [options]";
  for (const Option& option : command.options) {
    if (!option.is_positional()) continue;
    text += option.required ? " " + shown_name(option) : " [" + shown_name(option) + "]";
  }
  return text;
}

std::vector<std::pair<int, std::string>> exit_codes() {
  return {{jobs::kDone, "done and verified"},
          {jobs::kNo, "finished, but the answer is no (no net, no path, verify failed)"},
          {jobs::kUsage, "wrong usage"},
          {jobs::kBadInput, "unusable input"},
          {jobs::kFile, "cannot read or write a file"},
          {jobs::kTimeLimit, "time limit reached, best so far written"},
          {jobs::kInternal, "internal error"},
          {jobs::kMemory, "out of memory"},
          {jobs::kInterrupted, "interrupted, best so far written"}};
}

std::string command_help(const Job& command) {
  jobs::SharedOptions shared;
  std::vector<Option> others = with_shared_options(command, shared);
  others.erase(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(command.options.size()));
  return example_lines(command.examples) + "\n" + wrapped(command.summary + ".", 0, kLine) +
         "\n\nUsage: " + usage_line(command) + "\n" + section("Arguments", command.options, true) +
         section("Options", command.options, false) + section("Options of every command", others, false);
}

std::string group_help(const std::vector<Job>& group) {
  Rows rows, examples;
  for (const Job& command : group) {
    rows.emplace_back(command.name, command.summary);
    if (!command.examples.empty()) examples.push_back(command.examples.front());
  }
  return example_lines(examples) + "\nCommands:\n" + two_columns(rows) +
         "\nplico COMMAND --help tells more about one command.\n";
}

std::string program_help(const std::vector<Job>& commands) {
  Rows rows;
  for (const Job& command : commands) rows.emplace_back(command.name, command.summary);
  Rows codes;
  for (const auto& [code, meaning] : exit_codes()) codes.emplace_back(std::to_string(code), meaning);
  return example_lines(program_examples()) + "\nplico " + version() +
         " makes shapes foldable: a mesh becomes something that folds, a motion, and something to hold.\n"
         "\nUsage: plico COMMAND [options]\n\nCommands:\n" +
         two_columns(rows) + "\nplico COMMAND --help tells more about one command.\n\nExit codes:\n" +
         two_columns(codes);
}

}  // namespace plico::cli
