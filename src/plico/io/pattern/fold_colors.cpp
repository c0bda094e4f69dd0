#include "plico/io/pattern/fold_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr const char* kColors = "faces_plico:color";

}  // namespace

void set_colors(FoldFile& file, const std::vector<Color>& colors) {
  std::erase_if(file.other, [](const auto& entry) { return entry.first == kColors; });
  if (colors.empty()) return;
  nlohmann::json list;
  for (const Color& color : colors) list.push_back(hex_text(color));
  file.other.emplace_back(kColors, list.dump());
  std::ranges::sort(file.other);
}

std::vector<Color> colors_of(const FoldFile& file) {
  const auto entry = std::ranges::find(file.other, kColors, &std::pair<std::string, std::string>::first);
  if (entry == file.other.end()) return {};
  const nlohmann::json list = nlohmann::json::parse(entry->second);
  const int faces = file.net.sheet.num_faces();
  if (!list.is_array() || static_cast<int>(list.size()) != faces)
    throw InvalidInput("fold/color", fmt::format("{} must be one colour for each of {} faces", kColors, faces),
                       kColors);
  std::vector<Color> colors;
  for (const nlohmann::json& word : list) {
    const std::optional<Color> color = word.is_string() ? parse_hex(word.get<std::string>()) : std::nullopt;
    if (!color)
      throw InvalidInput("fold/color", fmt::format("{} is {}, must be like \"#1a2b3c\"", kColors, word.dump()),
                         fmt::format("{}[{}]", kColors, colors.size()));
    colors.push_back(*color);
  }
  return colors;
}

}  // namespace plico
