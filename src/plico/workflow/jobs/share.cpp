#include "plico/workflow/jobs/share.h"

#include <fmt/format.h>

#include <charconv>

#include "plico/base/error.h"

namespace plico::jobs {

double share_or_number(const std::string& option, const std::string& word, double whole) {
  const bool percent = word.ends_with('%');
  const char* last = word.data() + word.size() - (percent ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (error != std::errc() || end != last || !(value >= 0 && value <= 1e9))
    throw InvalidOption(fmt::format("{} = {} must be a number of at least 0, or one with %", option, word));
  return percent ? value / 100 * whole : value;
}

}  // namespace plico::jobs
