// plico man: the manual page, from the same table as --help.
#include <fmt/format.h>

#include <sstream>

#include "commands.h"
#include "help.h"
#include "plico/base/version.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/shared_options.h"

namespace plico::cli {
namespace {

// Text as roff reads it: no escapes, no line that looks like a request, minus signs that can be copied.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
  return result;
}

// Running text in short lines.
std::string prose(const std::string& text) {
  std::string result;
  std::istringstream lines(wrapped(text, 0, 72));
  for (std::string line; std::getline(lines, line);) result += roff(line) + "\n";
  return result;
}

std::string tagged(const std::string& tag, const std::string& text) {
  const auto first = tag.find_first_not_of(' ');
  return fmt::format(".TP\n\\fB{}\\fR\n{}", roff(tag.substr(first)), prose(text));
}

std::string examples_of(const std::vector<std::pair<std::string, std::string>>& examples, const char* before_first) {
  std::string text;
  for (const auto& [line, what] : examples)
    text += fmt::format("{}{}.PP\n.RS 4\n.nf\n{}\n.fi\n.RE\n", text.empty() ? before_first : ".PP\n", prose(what + ":"),
                        roff(line));
  return text;
}

std::string command_section(const Job& command) {
  std::string text = fmt::format(".SS plico {}\n{}.PP\n\\fB{}\\fR\n", roff(command.name), prose(command.summary + "."),
                                 roff(usage_line(command)));
  for (const Option& option : command.options) text += tagged(shown_name(option), full_help(option));
  return text + examples_of(command.examples, ".PP\n");
}

std::string man_page(const std::vector<Job>& commands) {
  std::string text = fmt::format(
      ".TH PLICO 1 {} \"plico {}\" \"User Commands\"\n"
      ".SH NAME\nplico \\- makes shapes foldable\n"
      ".SH SYNOPSIS\n.B plico\n.I COMMAND\n[options]\n"
      ".SH DESCRIPTION\nA mesh becomes something that folds, a motion, and something to hold.\n"
      "Results go to files or standard output; everything else goes to standard error.\n"
      "A file name of \\- means standard input or output.\n",
      PLICO_RELEASE_DATE, version());
  text += ".SH EXAMPLES\n" + examples_of(program_examples(), "");
  text += ".SH COMMANDS\n";
  for (const Job& command : commands) text += command_section(command);
  text += ".SH OPTIONS OF EVERY COMMAND\n";
  jobs::SharedOptions shared;
  for (const Option& option : shared_options(shared)) text += tagged(shown_name(option), full_help(option));
  text += tagged("-h, --help", "show examples and options");
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_codes()) text += tagged(std::to_string(code), meaning);
  return text;
}

}  // namespace

Job man_command() {
  return Job("man", "Write the manual page")
      .example("plico man | man -l -", "read the manual")
      .example("plico man -o plico.1", "keep it in a file")
      .example("plico man | mandoc -T html > plico.html", "as a web page")
      .action([](Session& session) {
        for (const std::string& path : session.outputs("-")) session.write(path, man_page(all_commands()));
        return int{jobs::kDone};
      });
}

}  // namespace plico::cli
