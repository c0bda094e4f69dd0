#include "plico/workflow/jobs/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/base/vec.h"
#include "plico/workflow/jobs/suggest.h"

namespace plico::jobs {
namespace {

std::vector<std::string> split_names(const std::string& flags) {
  const auto comma = flags.find(',');
  if (comma == std::string::npos) return {flags};
  return {flags.substr(0, comma), flags.substr(comma + 1)};
}

template <class Number>
Number parse_number(const std::string& text, const char* what) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::result_out_of_range)
    throw InvalidOption(fmt::format("'{}' is out of range for {}", text, what));
  if (error != std::errc() || end != text.data() + text.size())
    throw InvalidOption(fmt::format("'{}' is not {}", text, what));
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite(number)) throw InvalidOption(fmt::format("'{}' is not {}", text, what));
  return number;
}

std::string shown(double value, double unit, const char* suffix) {
  return std::isnan(value) ? "" : fmt::format("{:g}{}", value / unit, suffix);
}

Option row(const std::string& flags, const std::string& value, const std::string& help) {
  Option option;
  option.names = split_names(flags);
  option.value = value;
  option.help = help;
  return option;
}

// `read` sets the target and returns the number in the option's unit.
template <class Read>
void set_number(Option& option, const Range& range, const Read& read) {
  option.range = range;
  option.set = [read, range, unit = option.unit](const std::string& text) {
    if (!range.holds(static_cast<double>(read(text))))
      throw InvalidOption(fmt::format("{} must be {}{}{}", text, range.in_words(), unit.empty() ? "" : " ", unit));
  };
}

std::string help_of(const Job& job) { return fmt::format("plico {} --help", job.name); }

void set(const Option& option, const std::string& value) {
  try {
    if (option.is_flag() && value != "true") throw InvalidOption("takes no value");
    option.set(value);
  } catch (const InvalidOption& error) {
    throw InvalidOption(fmt::format("{}: {}", option.long_name(), error.what()), error.suggestion());
  }
}

void check_count(const Job& job, const Option& option, std::ptrdiff_t times) {
  if (option.required && times == 0)
    throw InvalidOption(fmt::format("{} is missing: {}", option.long_name(), option.help), help_of(job));
  if (!option.repeatable && times > 1)
    throw InvalidOption(fmt::format("{} is given {} times", option.long_name(), times), "give it once");
}

}  // namespace

bool Range::is_bounded() const { return std::isfinite(least) || std::isfinite(most); }

std::string Range::in_words() const {
  if (std::isinf(most)) return fmt::format("{} {:.10g}", with_least ? "at least" : "above", least);
  if (std::isinf(least)) return fmt::format("{} {:.10g}", with_most ? "at most" : "below", most);
  return fmt::format("in {}{:.10g}, {:.10g}{}", with_least ? '[' : '(', least, most, with_most ? ']' : ')');
}

Job::Job(std::string job_name, std::string job_summary) : name(std::move(job_name)), summary(std::move(job_summary)) {}

Job& Job::example(std::string command_line, std::string what_it_does) {
  examples.emplace_back(std::move(command_line), std::move(what_it_does));
  return *this;
}

Job& Job::add(Option option) {
  const auto place = option.is_positional()
                         ? std::ranges::find_if(options, [](const Option& o) { return !o.is_positional(); })
                         : options.end();
  options.insert(place, std::move(option));
  return *this;
}

Job& Job::positional(const std::string& positional_name, const std::string& help, std::string& target, bool required) {
  Option option = row(positional_name, "", help);
  option.required = required;
  option.shown_default = target;
  option.set = [&target](const std::string& text) { target = text; };
  return add(std::move(option));
}

Job& Job::positional(const std::string& positional_name, const std::string& help, std::vector<std::string>& target) {
  Option option = row(positional_name, "", help);
  option.required = option.repeatable = true;
  option.set = [&target](const std::string& text) { target.push_back(text); };
  return add(std::move(option));
}

Job& Job::flag(const std::string& flags, const std::string& help, bool& target) {
  Option option = row(flags, "", help);
  option.set = [&target](const std::string&) { target = true; };
  return add(std::move(option));
}

Job& Job::count(const std::string& flags, const std::string& help, int& target) {
  Option option = row(flags, "", help);
  option.repeatable = true;
  option.set = [&target](const std::string&) { ++target; };
  return add(std::move(option));
}

Job& Job::option(const std::string& flags, const std::string& value, const std::string& help, std::string& target) {
  Option option = row(flags, value, help);
  option.shown_default = target;
  option.set = [&target](const std::string& text) { target = text; };
  return add(std::move(option));
}

Job& Job::option(const std::string& flags, const std::string& value, const std::string& help, int& target,
                 Range range) {
  Option option = row(flags, value, help);
  option.shown_default = std::to_string(target);
  set_number(option, range,
             [&target](const std::string& text) { return target = parse_number<int>(text, "a whole number"); });
  return add(std::move(option));
}

Job& Job::option(const std::string& flags, const std::string& value, const std::string& help, double& target,
                 Range range) {
  Option option = row(flags, value, help);
  option.shown_default = shown(target, 1, "");
  set_number(option, range,
             [&target](const std::string& text) { return target = parse_number<double>(text, "a number"); });
  return add(std::move(option));
}

Job& Job::option(const std::string& flags, const std::string& value, const std::string& help, std::uint64_t& target,
                 Range range) {
  Option option = row(flags, value, help);
  option.shown_default = std::to_string(target);
  set_number(option, range, [&target](const std::string& text) {
    return target = parse_number<std::uint64_t>(text, "a whole number from 0 on");
  });
  return add(std::move(option));
}

Job& Job::option(const std::string& flags, const std::string& value, const std::string& help,
                 std::vector<std::string>& target) {
  Option option = row(flags, value, help);
  option.repeatable = true;
  option.set = [&target](const std::string& text) { target.push_back(text); };
  return add(std::move(option));
}

Job& Job::choice(const std::string& flags, const std::string& help, std::string& target,
                 std::vector<std::string> choices) {
  Option option = row(flags, "NAME", help);
  if (option.is_positional()) {
    option.value.clear();
    option.required = target.empty();
  }
  option.shown_default = target;
  option.choices = std::move(choices);
  option.set = [&target, allowed = option.choices](const std::string& text) {
    if (std::ranges::find(allowed, text) == allowed.end()) {
      const std::string nearest = nearest_word(text, allowed);
      throw InvalidOption(
          fmt::format("'{}' is not one of {}{}", text, fmt::join(allowed, ", "), did_you_mean(nearest)));
    }
    target = text;
  };
  return add(std::move(option));
}

Job& Job::length(const std::string& flags, const std::string& help, double& target_mm, Range range) {
  Option option = row(flags, "LENGTH", help);
  option.unit = "mm";
  option.shown_default = shown(target_mm, 1, "mm");
  set_number(option, range, [&target_mm](const std::string& text) { return target_mm = parse_length_mm(text); });
  return add(std::move(option));
}

Job& Job::angle(const std::string& flags, const std::string& help, double& target_radians, Range range) {
  Option option = row(flags, "ANGLE", help);
  option.unit = "deg";
  option.shown_default = shown(target_radians, kPi / 180, "deg");
  set_number(option, range,
             [&target_radians](const std::string& text) { return degrees(target_radians = parse_angle(text)); });
  return add(std::move(option));
}

Job& Job::duration(const std::string& flags, const std::string& help, double& target_seconds, Range range) {
  Option option = row(flags, "TIME", help);
  option.unit = "s";
  if (target_seconds > 0) option.shown_default = shown(target_seconds, 1, "s");
  set_number(option, range,
             [&target_seconds](const std::string& text) { return target_seconds = parse_duration(text); });
  return add(std::move(option));
}

Job& Job::action(std::function<int(Session&)> action) {
  run = std::move(action);
  return *this;
}

std::vector<Given> set_options(const Job& job, const std::vector<Option>& table, const std::vector<Given>& wanted) {
  std::vector<Given> given;
  for (const Option& option : table) {
    check_count(job, option, std::ranges::count(wanted, &option, &Given::option));
    for (const Given& one : wanted) {
      if (one.option != &option) continue;
      set(option, one.value);
      given.push_back(one);
    }
  }
  return given;
}

}  // namespace plico::jobs
