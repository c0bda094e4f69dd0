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

// Rules of a style sheet whose selectors are ".class", "element", "element.class" or "*", by selector; others are
// skipped.
std::map<std::string, SvgStyle, std::less<>> parse_style_sheet(std::string_view text);

// 0xrrggbb of #rgb, #rrggbb, rgb(r, g, b) or one of the six names that matter here; nothing for others.
std::optional<int> parse_color(std::string_view text);

// The numbers of a list separated by blanks, commas or signs, as SVG packs them; false when something else stands
// there.
bool parse_number_list(std::string_view text, std::vector<double>& numbers);

// translate, scale, rotate, skewX, skewY and matrix, one after the other; nothing when malformed.
std::optional<Eigen::Affine2d> parse_transform(std::string_view text);

}  // namespace plico
