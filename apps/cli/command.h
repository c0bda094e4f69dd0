// The table every command is described by. Parsing, --help, the man page and the shell completions all read it, so they
// cannot disagree.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace plico::cli {

class Session;

struct Option {
  std::vector<std::string> names;  // "-o", "--output"; a positional has one name without dashes
  std::string value;               // what stands for the value in help: "FILE"; empty for a flag
  std::string help;
  std::string shown_default;         // empty when there is none
  std::vector<std::string> choices;  // empty: any value
  bool required = false;
  bool repeatable = false;
  std::function<void(const std::string&)> set;  // throws InvalidOption; a flag is set with "true"

  bool is_positional() const { return !names.front().starts_with('-'); }
  bool is_flag() const { return !is_positional() && value.empty(); }
  const std::string& long_name() const { return names.back(); }  // as messages and reports call it
};

class Command {
 public:
  // `name` is one word or two ("origami info").
  Command(std::string name, std::string summary);

  // At least three, shown first by --help.
  Command& example(std::string command_line, std::string what_it_does);
  Command& positional(const std::string& name, const std::string& help, std::string& target, bool required = true);
  Command& positional(const std::string& name, const std::string& help, std::vector<std::string>& target);

  // `flags` is "-o,--output"; the default shown is the target's value now. Numbers must be finite and in the type's
  // range.
  Command& flag(const std::string& flags, const std::string& help, bool& target);
  Command& count(const std::string& flags, const std::string& help, int& target);  // a flag that may be repeated
  Command& option(const std::string& flags, const std::string& value, const std::string& help, std::string& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, int& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, double& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, std::uint64_t& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help,
                  std::vector<std::string>& target);
  // One of a few names; "shell" without dashes makes it a positional.
  Command& choice(const std::string& flags, const std::string& help, std::string& target,
                  std::vector<std::string> choices);
  // A length in millimetres: "150mm", "15cm", "6in"; a plain number is millimetres. NaN means not given.
  Command& length(const std::string& flags, const std::string& help, double& target_mm);
  // An angle in radians: "30deg", "0.5rad"; a plain number is degrees. NaN means not given.
  Command& angle(const std::string& flags, const std::string& help, double& target_radians);
  // A duration in seconds: "30s", "2m"; a plain number is seconds. 0 means not given.
  Command& duration(const std::string& flags, const std::string& help, double& target_seconds);

  // Runs the command; returns the exit code. The options' targets live as long as this function object.
  Command& action(std::function<int(Session&)> run);

  std::string name, summary;
  std::vector<std::pair<std::string, std::string>> examples;
  std::vector<Option> options;  // positionals first
  std::function<int(Session&)> run;

 private:
  Command& add(Option option);
};

}  // namespace plico::cli
