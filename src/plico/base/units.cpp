#include "plico/base/units.h"

#include <charconv>
#include <cmath>
#include <span>

#include "plico/base/error.h"
#include "plico/base/vec.h"

namespace plico {
namespace {

struct Unit {
  std::string_view name;
  double factor;
};

constexpr Unit kLengths[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}, {"ft", 304.8}};
constexpr Unit kAngles[] = {{"deg", kPi / 180}, {"rad", 1}};
constexpr Unit kDurations[] = {{"s", 1}, {"ms", 0.001}, {"m", 60}, {"h", 3600}};

// What a kind of quantity accepts and how its messages read.
struct Kind {
  std::span<const Unit> units;  // the first one is meant when none is written
  std::string_view what, examples;
};

double factor_of(const Kind& kind, std::string_view unit, std::string_view text) {
  if (unit.empty()) return kind.units.front().factor;
  for (const Unit& known : kind.units)
    if (known.name == unit) return known.factor;
  throw InvalidOption(fmt::format("'{}' is not {}: its unit '{}' is unknown", text, kind.what, unit),
                      fmt::format("write {}", kind.examples));
}

double parse(const Kind& kind, std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number))
    throw InvalidOption(fmt::format("'{}' is not {}", text, kind.what), fmt::format("write {}", kind.examples));
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  return number * factor_of(kind, unit, text);
}

constexpr Kind kLength{kLengths, "a length", "150mm, 15cm or 6in"};

}  // namespace

double parse_length_mm(std::string_view text) { return parse(kLength, text); }

double parse_angle(std::string_view text) { return parse({kAngles, "an angle", "30deg or 0.5rad"}, text); }

double parse_duration(std::string_view text) {
  const double seconds = parse({kDurations, "a duration", "30s, 2m or 1h"}, text);
  if (seconds < 0) throw InvalidOption(fmt::format("'{}' is a negative duration", text), "write 30s, 2m or 1h");
  return seconds;
}

double millimetres_per(std::string_view unit) {
  for (const Unit& known : kLengths)
    if (known.name == unit) return known.factor;
  throw InvalidOption(fmt::format("'{}' is not a unit of length", unit), "write mm, cm, m, in or ft");
}

}  // namespace plico
