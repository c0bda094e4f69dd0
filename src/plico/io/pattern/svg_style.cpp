#include "plico/io/pattern/svg_style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "plico/base/libm.h"
#include "plico/io/text/text_scanner.h"

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

std::optional<SvgColor> parse_hex(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return {};
  if (digits.size() == 3 || digits.size() == 4) {  // each digit stands for two
    std::uint32_t wide = 0;
    for (std::size_t i = digits.size(); i-- > 0;) wide = wide << 8 | (value >> (4 * i) & 15) * 0x11;
    value = wide;
  }
  if (digits.size() == 4 || digits.size() == 8) return SvgColor{static_cast<int>(value >> 8), (value & 255) / 255.0};
  if (digits.size() != 3 && digits.size() != 6) return {};
  return SvgColor{static_cast<int>(value)};
}

// "50%" of `whole`, "120deg", "0.5".
std::optional<double> color_part(std::string_view part, double whole) {
  const bool percent = part.ends_with('%');
  if (percent) part.remove_suffix(1);
  if (part.ends_with("deg")) part.remove_suffix(3);
  double value = 0;
  if (!parse_number(part, value) || !std::isfinite(value)) return {};
  return percent ? value / 100 * whole : value;
}

std::vector<std::string_view> words(std::string_view text, std::string_view between = kBlank) {
  std::vector<std::string_view> result;
  for (auto at = text.find_first_not_of(between); at != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(between, at), text.size());
    result.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(between, end);
  }
  return result;
}

std::string without_comments(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const auto start = text.find("/*", i);
    plain += text.substr(i, start - i);
    const auto end = start == std::string_view::npos ? start : text.find("*/", start + 2);
    i = end == std::string_view::npos ? text.size() : end + 2;
  }
  return plain;
}

// Of the brace that closes the one at `open`; the end of the text when none does.
std::size_t end_of_block(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i;
  }
  return text.size();
}

int packed(double red, double green, double blue) {
  int color = 0;
  for (double part : {red, green, blue})
    color = color << 8 | static_cast<int>(std::lround(std::clamp(part, 0.0, 255.0)));
  return color;
}

// Hue in degrees, saturation and lightness in [0, 1].
int packed_hsl(double hue, double saturation, double lightness) {
  saturation = std::clamp(saturation, 0.0, 1.0), lightness = std::clamp(lightness, 0.0, 1.0);
  const double reach = saturation * std::min(lightness, 1 - lightness);
  const auto part = [&](double from) {
    const double k = std::fmod(std::fmod(from + hue / 30, 12) + 12, 12);
    return 255 * (lightness - reach * std::max(-1.0, std::min({k - 3, 9 - k, 1.0})));
  };
  return packed(part(0), part(8), part(4));
}

std::optional<SvgColor> parse_function(bool hsl, std::string_view arguments) {
  const std::vector<std::string_view> given = words(arguments, " \t\r\n\f,/");  // a slash before alpha
  if (given.size() != 3 && given.size() != 4) return {};
  std::array<double, 4> parts{0, 0, 0, 1};
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::optional<double> part = color_part(given[i], i == 3 || hsl ? 1 : 255);
    if (!part) return {};
    parts[i] = *part;
  }
  const int rgb = hsl ? packed_hsl(parts[0], parts[1], parts[2]) : packed(parts[0], parts[1], parts[2]);
  return SvgColor{rgb, std::clamp(parts[3], 0.0, 1.0)};
}

std::optional<int> named_color(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, int>, 24> kNames{
      {{"red", 0xff0000},     {"blue", 0x0000ff},      {"black", 0x000000},   {"lime", 0x00ff00},
       {"green", 0x008000},   {"yellow", 0xffff00},    {"magenta", 0xff00ff}, {"fuchsia", 0xff00ff},
       {"white", 0xffffff},   {"gray", 0x808080},      {"grey", 0x808080},    {"silver", 0xc0c0c0},
       {"maroon", 0x800000},  {"navy", 0x000080},      {"olive", 0x808000},   {"purple", 0x800080},
       {"teal", 0x008080},    {"aqua", 0x00ffff},      {"cyan", 0x00ffff},    {"orange", 0xffa500},
       {"crimson", 0xdc143c}, {"royalblue", 0x4169e1}, {"darkred", 0x8b0000}, {"darkblue", 0x00008b}}};
  for (const auto& [known, value] : kNames)
    if (name == known) return value;
  return {};
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

void SvgRules::add(std::string_view text) {
  const std::string plain = without_comments(text);
  std::string_view rest = plain;
  for (auto open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    std::string_view selectors = rest.substr(0, open);
    if (const auto statement = selectors.rfind(';'); statement != std::string_view::npos)
      selectors.remove_prefix(statement + 1);  // @import "...";
    const auto close = end_of_block(rest, open);
    const std::string_view block = rest.substr(open + 1, close - open - 1);
    if (trimmed(selectors).starts_with('@') || block.find('{') != std::string_view::npos)
      ++left_out_;
    else
      split(selectors, ',', [&, style = parse_declarations(block)](auto selector) { add_rule(selector, style); });
    if (close >= rest.size()) break;
    rest.remove_prefix(close + 1);
  }
}

std::optional<SvgRules::Compound> SvgRules::compound(std::string_view word) {
  Compound result;
  for (std::size_t at = 0; at < word.size();) {
    const auto end = std::min(word.find_first_of(".#", at + 1), word.size());
    const std::string_view part = word.substr(at, end - at), name = part.substr(part[0] == '.' || part[0] == '#');
    const bool any = at == 0 && part == "*";
    if (!any && (name.empty() || name.find_first_of("*@:[]+~()=\"'\\") != std::string_view::npos)) return {};
    if (part[0] == '.')
      result.classes.emplace_back(name);
    else if (part[0] == '#')
      result.id = name;
    else if (!any)
      result.element = name;
    at = end;
  }
  return result;
}

void SvgRules::add_rule(std::string_view selector, const SvgStyle& style) {
  std::string spaced;
  for (const char c : selector) spaced += c == '>' ? " > " : std::string(1, c);
  Rule rule;
  rule.style = style;
  bool child = false, understood = true;
  for (const std::string_view word : words(spaced)) {
    if (word == ">") {
      understood = understood && !child && !rule.compounds.empty();
      child = true;
      continue;
    }
    std::optional<Compound> next = compound(word);
    if (!next) {
      ++left_out_;
      return;
    }
    next->child = std::exchange(child, false);
    rule.compounds.insert(rule.compounds.begin(), std::move(*next));
  }
  if (!understood || child || rule.compounds.empty()) {
    ++left_out_;
    return;
  }
  const auto heavier = std::find_if(rules_.begin(), rules_.end(),
                                    [weight = rule.weight()](const Rule& r) { return r.weight() > weight; });
  rules_.insert(heavier, std::move(rule));
}

int SvgRules::Rule::weight() const {
  int sum = 0;
  for (const Compound& c : compounds)
    sum += 10000 * !c.id.empty() + 100 * static_cast<int>(c.classes.size()) + !c.element.empty();
  return sum;
}

bool SvgRules::Compound::fits(const SvgElement& e) const {
  if (!element.empty() && element != e.name) return false;
  if (!id.empty() && id != e.id) return false;
  const std::vector<std::string_view> own = words(e.classes);
  return std::all_of(classes.begin(), classes.end(),
                     [&](const std::string& name) { return std::find(own.begin(), own.end(), name) != own.end(); });
}

// From the inside out: which elements of the chain the compound may stand at, given where the one inside it may.
bool SvgRules::Rule::fits(const std::vector<SvgElement>& chain) const {
  if (chain.empty() || !compounds[0].fits(chain[0])) return false;
  std::vector<char> at(chain.size(), 0);
  at[0] = 1;
  for (std::size_t k = 1; k < compounds.size(); ++k) {
    std::vector<char> next(chain.size(), 0);
    bool inside = false, any = false;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      inside = compounds[k - 1].child ? at[i - 1] != 0 : inside || at[i - 1] != 0;
      next[i] = inside && compounds[k].fits(chain[i]);
      any = any || next[i] != 0;
    }
    if (!any) return false;
    at.swap(next);
  }
  return true;
}

SvgStyle SvgRules::style_of(const std::vector<SvgElement>& chain) const {
  SvgStyle style;
  for (const Rule& rule : rules_) {
    if (!rule.fits(chain)) continue;
    for (const auto& [key, value] : rule.style) style[key] = value;
  }
  return style;
}

std::optional<SvgColor> parse_color(std::string_view text) {
  const std::string color = lower(trimmed(text));
  if (color.starts_with('#') && color.size() > 1) return parse_hex(std::string_view(color).substr(1));
  const auto open = color.find('(');
  if (open != std::string::npos && color.ends_with(')')) {
    const std::string_view name = trimmed(std::string_view(color).substr(0, open));
    const bool rgb = name == "rgb" || name == "rgba", hsl = name == "hsl" || name == "hsla";
    if (!rgb && !hsl) return {};
    return parse_function(hsl, std::string_view(color).substr(open + 1, color.size() - open - 2));
  }
  const std::optional<int> named = named_color(color);
  return named ? std::optional(SvgColor{*named}) : std::nullopt;
}

std::optional<double> parse_opacity(std::string_view text) {
  const std::optional<double> value = color_part(trimmed(text), 1);
  return value ? std::optional(std::clamp(*value, 0.0, 1.0)) : std::nullopt;
}

std::optional<double> parse_length(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{
      {{"px", 1}, {"pt", 96.0 / 72}, {"pc", 16}, {"mm", 96 / 25.4}, {"cm", 960 / 25.4}, {"in", 96}, {"", 1}}};
  const std::string length = lower(trimmed(text));
  for (const auto& [unit, size] : kUnits) {
    if (!length.ends_with(unit)) continue;
    double value = 0;
    if (!parse_number(trimmed(std::string_view(length).substr(0, length.size() - unit.size())), value)) return {};
    return std::isfinite(value) ? std::optional(value * size) : std::nullopt;
  }
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
