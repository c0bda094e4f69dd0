#include "plico/io/text/parse_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"

namespace plico {
namespace {

// nlohmann's writer recurses once per level, so a deep file could run out of stack.
void check_depth(std::string_view bytes, const std::string& name, const std::string& kind) {
  constexpr int kDeepest = 100;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (in_string && c == '\\')
      ++i;
    else if (c == '"')
      in_string = !in_string;
    else if (!in_string && (c == '[' || c == '{') && ++depth > kDeepest)
      throw InvalidInput(kind + "/depth", fmt::format("the JSON is nested more than {} levels deep", kDeepest),
                         fmt::format("{}, byte {}", name, i));
    else if (!in_string && (c == ']' || c == '}'))
      --depth;
  }
}

}  // namespace

nlohmann::json parse_json(std::string_view bytes, const std::string& name, const std::string& kind) {
  check_depth(bytes, name, kind);
  try {
    return nlohmann::json::parse(bytes);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t at = std::min(error.byte == 0 ? 0 : error.byte - 1, bytes.size());
    const auto line = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
    const std::size_t start = at == 0 ? 0 : bytes.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    const bool ended = at >= bytes.size();
    throw InvalidInput(kind + "/json", ended ? "the file ends in the middle of its JSON" : "the file is not JSON",
                       fmt::format("{}:{}:{}", name, line, at - start + 1));
  } catch (const nlohmann::json::out_of_range&) {
    throw InvalidInput(kind + "/number", "the file holds a number that is too large for a double", name);
  }
}

}  // namespace plico
