#include "command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/base/vec.h"
#include "suggest.h"

namespace plico::cli {
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

}  // namespace

Command::Command(std::string command_name, std::string command_summary)
    : name(std::move(command_name)), summary(std::move(command_summary)) {}

Command& Command::example(std::string command_line, std::string what_it_does) {
  examples.emplace_back(std::move(command_line), std::move(what_it_does));
  return *this;
}

Command& Command::add(Option option) {
  const auto place = option.is_positional()
                         ? std::ranges::find_if(options, [](const Option& o) { return !o.is_positional(); })
                         : options.end();
  options.insert(place, std::move(option));
  return *this;
}

Command& Command::positional(const std::string& positional_name, const std::string& help, std::string& target,
                             bool required) {
  Option option = row(positional_name, "", help);
  option.required = required;
  option.shown_default = target;
  option.set = [&target](const std::string& text) { target = text; };
  return add(std::move(option));
}

Command& Command::positional(const std::string& positional_name, const std::string& help,
                             std::vector<std::string>& target) {
  Option option = row(positional_name, "", help);
  option.required = option.repeatable = true;
  option.set = [&target](const std::string& text) { target.push_back(text); };
  return add(std::move(option));
}

Command& Command::flag(const std::string& flags, const std::string& help, bool& target) {
  Option option = row(flags, "", help);
  option.set = [&target](const std::string&) { target = true; };
  return add(std::move(option));
}

Command& Command::count(const std::string& flags, const std::string& help, int& target) {
  Option option = row(flags, "", help);
  option.repeatable = true;
  option.set = [&target](const std::string&) { ++target; };
  return add(std::move(option));
}

Command& Command::option(const std::string& flags, const std::string& value, const std::string& help,
                         std::string& target) {
  Option option = row(flags, value, help);
  option.shown_default = target;
  option.set = [&target](const std::string& text) { target = text; };
  return add(std::move(option));
}

Command& Command::option(const std::string& flags, const std::string& value, const std::string& help, int& target) {
  Option option = row(flags, value, help);
  option.shown_default = std::to_string(target);
  option.set = [&target](const std::string& text) { target = parse_number<int>(text, "a whole number"); };
  return add(std::move(option));
}

Command& Command::option(const std::string& flags, const std::string& value, const std::string& help, double& target) {
  Option option = row(flags, value, help);
  option.shown_default = shown(target, 1, "");
  option.set = [&target](const std::string& text) { target = parse_number<double>(text, "a number"); };
  return add(std::move(option));
}

Command& Command::option(const std::string& flags, const std::string& value, const std::string& help,
                         std::uint64_t& target) {
  Option option = row(flags, value, help);
  option.shown_default = std::to_string(target);
  option.set = [&target](const std::string& text) {
    target = parse_number<std::uint64_t>(text, "a whole number from 0 on");
  };
  return add(std::move(option));
}

Command& Command::option(const std::string& flags, const std::string& value, const std::string& help,
                         std::vector<std::string>& target) {
  Option option = row(flags, value, help);
  option.repeatable = true;
  option.set = [&target](const std::string& text) { target.push_back(text); };
  return add(std::move(option));
}

Command& Command::choice(const std::string& flags, const std::string& help, std::string& target,
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

Command& Command::length(const std::string& flags, const std::string& help, double& target_mm) {
  Option option = row(flags, "LENGTH", help);
  option.shown_default = shown(target_mm, 1, "mm");
  option.set = [&target_mm](const std::string& text) { target_mm = parse_length_mm(text); };
  return add(std::move(option));
}

Command& Command::angle(const std::string& flags, const std::string& help, double& target_radians) {
  Option option = row(flags, "ANGLE", help);
  option.shown_default = shown(target_radians, kPi / 180, "deg");
  option.set = [&target_radians](const std::string& text) { target_radians = parse_angle(text); };
  return add(std::move(option));
}

Command& Command::duration(const std::string& flags, const std::string& help, double& target_seconds) {
  Option option = row(flags, "TIME", help);
  if (target_seconds > 0) option.shown_default = shown(target_seconds, 1, "s");
  option.set = [&target_seconds](const std::string& text) { target_seconds = parse_duration(text); };
  return add(std::move(option));
}

Command& Command::action(std::function<int(Session&)> action) {
  run = std::move(action);
  return *this;
}

}  // namespace plico::cli
