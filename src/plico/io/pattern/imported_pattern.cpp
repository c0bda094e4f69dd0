#include "plico/io/pattern/imported_pattern.h"

#include <fmt/format.h>

#include <cmath>

#include "plico/base/error.h"

namespace plico {

void check(const DrawingOptions& options) {
  const auto at_least_zero = [](const char* name, double value) {
    if (!(value >= 0 && std::isfinite(value)))
      throw InvalidOption(fmt::format("{} = {:g} must be a length, at least 0", name, value));
  };
  at_least_zero("merge", options.merge);
  at_least_zero("flatten", options.flatten);
}

}  // namespace plico
