#include "highlight.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace plico::cli {
namespace {

bool has_colours() {
  const char *refused = std::getenv("NO_COLOR"), *kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) && !(refused && *refused) && kind && std::string_view(kind) != "dumb";
}

}  // namespace

std::string highlighted(std::string_view text, Highlight kind) {
  static const bool colours = has_colours();
  if (!colours) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", kind == Highlight::Error ? "1;31" : "1;33", text);
}

}  // namespace plico::cli
