#include "plico/io/pattern/svg_style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

constexpr std::string_view kBlank = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlank);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

// Calls use(part) for every part between separators.
template <class Use>
void split(std::string_view text, char separator, Use use) {
  while (true) {
    const auto at = text.find(separator);
    use(trimmed(text.substr(0, at)));
    if (at == std::string_view::npos) return;
    text.remove_prefix(at + 1);
  }
}

std::optional<int> parse_hex(std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size() || digits[0] == '-') return {};
  if (digits.size() == 6) return value;
  if (digits.size() != 3) return {};
  return ((value >> 8) * 0x11) << 16 | ((value >> 4 & 15) * 0x11) << 8 | (value & 15) * 0x11;
}

std::optional<int> parse_rgb(std::string_view arguments) {
  std::vector<double> parts;
  const bool percent = arguments.find('%') != std::string_view::npos;
  std::string text(arguments);
  std::erase(text, '%');
  if (!parse_number_list(text, parts) || parts.size() != 3) return {};
  int color = 0;
  for (double part : parts)
    color = color << 8 | static_cast<int>(std::lround(std::clamp(percent ? part * 2.55 : part, 0.0, 255.0)));
  return color;
}

std::optional<Eigen::Affine2d> one_transform(std::string_view name, const std::vector<double>& a) {
  Eigen::Affine2d t = Eigen::Affine2d::Identity();
  const std::size_t n = a.size();
  if (name == "translate" && (n == 1 || n == 2)) return t.translate(Vec2(a[0], n == 2 ? a[1] : 0));
  if (name == "scale" && (n == 1 || n == 2)) return t.scale(Vec2(a[0], n == 2 ? a[1] : a[0]));
  if (name == "rotate" && n == 1) return t.rotate(rotation(radians(a[0])));
  if (name == "rotate" && n == 3) {
    const Vec2 centre(a[1], a[2]);
    return t.translate(centre).rotate(rotation(radians(a[0]))).translate(-centre);
  }
  if (name == "skewX" && n == 1) return t.shear(plico::tan(radians(a[0])), 0);
  if (name == "skewY" && n == 1) return t.shear(0, plico::tan(radians(a[0])));
  if (name != "matrix" || n != 6) return {};
  t.matrix() << a[0], a[2], a[4], a[1], a[3], a[5], 0, 0, 1;
  return t;
}

}  // namespace

SvgStyle parse_declarations(std::string_view text) {
  SvgStyle style;
  split(text, ';', [&](std::string_view part) {
    const auto colon = part.find(':');
    if (colon == std::string_view::npos) return;
    std::string_view value = trimmed(part.substr(colon + 1));
    value = trimmed(value.substr(0, value.find("!important")));
    style[lower(trimmed(part.substr(0, colon)))] = value;
  });
  return style;
}

std::map<std::string, SvgStyle, std::less<>> parse_style_sheet(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const auto start = text.find("/*", i);
    plain += text.substr(i, start - i);
    const auto end = start == std::string_view::npos ? start : text.find("*/", start + 2);
    i = end == std::string_view::npos ? text.size() : end + 2;
  }
  std::map<std::string, SvgStyle, std::less<>> rules;
  std::string_view rest = plain;
  for (auto open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    const auto close = rest.find('}', open);
    const SvgStyle style = parse_declarations(rest.substr(open + 1, close - open - 1));
    split(rest.substr(0, open), ',', [&](std::string_view selector) {
      for (const auto& [key, value] : style) rules[std::string(selector)][key] = value;
    });
    if (close == std::string_view::npos) break;
    rest.remove_prefix(close + 1);
  }
  return rules;
}

std::optional<int> parse_color(std::string_view text) {
  const std::string color = lower(trimmed(text));
  if (color.starts_with('#') && color.size() > 1) return parse_hex(std::string_view(color).substr(1));
  if (color.starts_with("rgb(") && color.ends_with(')'))
    return parse_rgb(std::string_view(color).substr(4, color.size() - 5));
  constexpr std::array<std::pair<std::string_view, int>, 7> kNames{{{"red", 0xff0000},
                                                                    {"blue", 0x0000ff},
                                                                    {"black", 0},
                                                                    {"lime", 0x00ff00},
                                                                    {"yellow", 0xffff00},
                                                                    {"magenta", 0xff00ff},
                                                                    {"fuchsia", 0xff00ff}}};
  for (const auto& [name, value] : kNames)
    if (color == name) return value;
  return {};
}

bool parse_number_list(std::string_view text, std::vector<double>& numbers) {
  while (true) {
    const auto at = text.find_first_not_of(" \t\r\n\f,");
    if (at == std::string_view::npos) return true;
    text.remove_prefix(at);
    if (text[0] == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

std::optional<Eigen::Affine2d> parse_transform(std::string_view text) {
  Eigen::Affine2d result = Eigen::Affine2d::Identity();
  while (true) {
    const auto start = text.find_first_not_of(" \t\r\n\f,");
    if (start == std::string_view::npos) return result;
    const auto open = text.find('(', start), close = text.find(')', start);
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
    std::vector<double> arguments;
    if (!parse_number_list(text.substr(open + 1, close - open - 1), arguments)) return {};
    const auto next = one_transform(trimmed(text.substr(start, open - start)), arguments);
    if (!next) return {};
    result = result * *next;
    text.remove_prefix(close + 1);
  }
}

}  // namespace plico
