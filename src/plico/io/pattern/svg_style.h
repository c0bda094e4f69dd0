// Strokes, rules and transforms of SVG elements, for the reader of crease patterns.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

using SvgStyle = std::map<std::string, std::string, std::less<>>;  // property -> value

// "stroke:#f00; opacity:.5" as properties.
SvgStyle parse_declarations(std::string_view text);

// What selectors ask about an element.
struct SvgElement {
  std::string_view name, id, classes;
};

// The rules of a style sheet. Selectors are elements with any of name, id and classes ("path", ".cut", "#rim",
// "line.m.thick", "*"), each inside the one before ("g.v line") or right inside it ("#rim > line"). A rule with
// anything else (":hover", "[x]", "+", "~", "@media") colours nothing, as nobody knows what it would colour: it is left
// out.
class SvgRules {
 public:
  void add(std::string_view text);
  bool empty() const { return rules_.empty(); }
  int num_left_out() const { return left_out_; }
  // What the rules say about the first of `chain`, an element and those around it, the nearest first: from the general
  // to the special, the later above the earlier. O(rules * elements).
  SvgStyle style_of(const std::vector<SvgElement>& chain) const;

 private:
  struct Compound {
    std::string element, id;  // empty: any
    std::vector<std::string> classes;
    bool child = false;  // stands right inside the next one
    bool fits(const SvgElement& element) const;
  };
  struct Rule {
    std::vector<Compound> compounds;  // the innermost first
    SvgStyle style;
    int weight() const;
    bool fits(const std::vector<SvgElement>& chain) const;
  };
  static std::optional<Compound> compound(std::string_view word);
  void add_rule(std::string_view selector, const SvgStyle& style);
  std::vector<Rule> rules_;
  int left_out_ = 0;
};

struct SvgColor {
  int rgb = 0;       // 0xrrggbb
  double alpha = 1;  // in [0, 1]
};

// #rgb, #rrggbb, both with alpha, rgb(), rgba(), hsl(), hsla() with commas or blanks, and the names of CSS that
// somebody might draw lines with; nothing for others.
std::optional<SvgColor> parse_color(std::string_view text);

// "0.5", " 50% ": in [0, 1] or cut to it; nothing when it is no number.
std::optional<double> parse_opacity(std::string_view text);

// The numbers of a list separated by blanks, commas or signs, as SVG packs them; false when something else stands
// there.
bool parse_number_list(std::string_view text, std::vector<double>& numbers);

// A length in user units, of 1/96 in: "12", "3mm"; nothing when it is none, or a percentage.
std::optional<double> parse_length(std::string_view text);

// translate, scale, rotate, skewX, skewY and matrix, one after the other; nothing when malformed.
std::optional<Eigen::Affine2d> parse_transform(std::string_view text);

}  // namespace plico
