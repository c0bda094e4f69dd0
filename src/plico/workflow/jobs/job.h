// What a job is called, asks for and does. This one table is read by the command line, --help, the manual page, the
// shell completions, reports, and programs that run jobs, so that they cannot disagree.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace plico::jobs {

class Session;

// Numbers that an option takes, in its unit. The library checks what it is given by itself; this says it before any
// file is read, and to forms.
struct Range {
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  bool with_least = true, with_most = true;  // whether the bounds themselves are taken

  bool holds(double x) const { return (with_least ? x >= least : x > least) && (with_most ? x <= most : x < most); }
  bool is_bounded() const;
  std::string in_words() const;  // "at least 1", "above 0", "in [0, 1)"; not of a range without bounds
};
inline Range at_least(double least) { return {.least = least}; }
inline Range above(double least) { return {.least = least, .with_least = false}; }

struct Option {
  std::vector<std::string> names;  // "-o", "--output"; a positional has one name without dashes
  std::string value;               // what stands for the value in help: "FILE"; empty for a flag
  std::string unit;                // of a plain number: "mm", "deg", "s"; empty where there is none
  std::string help;
  std::string shown_default;         // empty when there is none
  std::vector<std::string> choices;  // empty: any value
  bool required = false;
  bool repeatable = false;
  std::function<void(const std::string&)> set;  // throws InvalidOption; a flag is set with "true"
  Range range;                                  // of numbers: nothing else is taken

  bool is_positional() const { return !names.front().starts_with('-'); }
  bool is_flag() const { return !is_positional() && value.empty(); }
  const std::string& long_name() const { return names.back(); }  // as messages and reports call it
};

// One option or positional as it was given; a flag has the value "true".
struct Given {
  const Option* option = nullptr;
  std::string value;
};

// A request is the options' targets: the struct of a job's own, filled by set_options().
class Job {
 public:
  // `name` is one word or two ("origami info").
  Job(std::string name, std::string summary);

  // At least three, shown first by --help.
  Job& example(std::string command_line, std::string what_it_does);
  Job& positional(const std::string& name, const std::string& help, std::string& target, bool required = true);
  Job& positional(const std::string& name, const std::string& help, std::vector<std::string>& target);

  // `flags` is "-o,--output"; the default shown is the target's value now. Numbers must be finite, and in the range of
  // the type and of the option.
  Job& flag(const std::string& flags, const std::string& help, bool& target);
  Job& count(const std::string& flags, const std::string& help, int& target);  // a flag that may be repeated
  Job& option(const std::string& flags, const std::string& value, const std::string& help, std::string& target);
  Job& option(const std::string& flags, const std::string& value, const std::string& help, int& target,
              Range range = {});
  Job& option(const std::string& flags, const std::string& value, const std::string& help, double& target,
              Range range = {});
  Job& option(const std::string& flags, const std::string& value, const std::string& help, std::uint64_t& target,
              Range range = {});
  Job& option(const std::string& flags, const std::string& value, const std::string& help,
              std::vector<std::string>& target);
  // One of a few names; "shell" without dashes makes it a positional.
  Job& choice(const std::string& flags, const std::string& help, std::string& target, std::vector<std::string> choices);
  // A length in millimetres: "150mm", "15cm", "6in"; a plain number is millimetres. NaN means not given.
  Job& length(const std::string& flags, const std::string& help, double& target_mm, Range range = {});
  // An angle in radians: "30deg", "0.5rad"; a plain number is degrees. NaN means not given.
  Job& angle(const std::string& flags, const std::string& help, double& target_radians, Range range = {});
  // A duration in seconds: "30s", "2m"; a plain number is seconds. 0 means not given.
  Job& duration(const std::string& flags, const std::string& help, double& target_seconds, Range range = {});

  // Does the work; returns the exit code. The options' targets live as long as this function object.
  Job& action(std::function<int(Session&)> run);

  std::string name, summary;
  std::vector<std::pair<std::string, std::string>> examples;
  std::vector<Option> options;  // positionals first
  std::function<int(Session&)> run;

 private:
  Job& add(Option option);
};

// Sets every option of `table` that is wanted, in the table's order, and returns them so; the result points into the
// table. Throws InvalidOption, naming the option: a bad value, one given twice, one that is missing.
std::vector<Given> set_options(const Job& job, const std::vector<Option>& table, const std::vector<Given>& wanted);

}  // namespace plico::jobs
