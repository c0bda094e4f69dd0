// The table every command is described by. Parsing, --help, the man page and the shell completions all read it, so they
// cannot disagree.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
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
};

class Command {
 public:
  Command(std::string name, std::string summary);

  // At least three, shown first by --help.
  Command& example(std::string command_line, std::string what_it_does);
  Command& positional(const std::string& name, const std::string& help, std::string& target, bool required = true);
  Command& positional(const std::string& name, const std::string& help, std::vector<std::string>& target);

  // `flags` is "-o,--output"; the default shown is the target's value now.
  Command& flag(const std::string& flags, const std::string& help, bool& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, std::string& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, int& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, double& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help, std::uint64_t& target);
  Command& option(const std::string& flags, const std::string& value, const std::string& help,
                  std::vector<std::string>& target);
  Command& choice(const std::string& flags, const std::string& help, std::string& target,
                  std::vector<std::string> choices);
  // A length in millimetres: "150mm", "15cm", "6in"; a plain number is millimetres. NaN means not given.
  Command& length(const std::string& flags, const std::string& help, double& target_mm);
  // An angle in radians: "30deg", "0.5rad"; a plain number is degrees.
  Command& angle(const std::string& flags, const std::string& help, double& target_radians);

  // Runs the command; returns the exit code. The options' targets live as long as this function object.
  Command& action(std::function<int(Session&)> run);

  std::string name, summary;
  std::vector<std::pair<std::string, std::string>> examples;
  std::vector<Option> options;  // positionals first
  std::function<int(Session&)> run;
};

}  // namespace plico::cli
