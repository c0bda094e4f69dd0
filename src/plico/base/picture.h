// Pictures made of pixels, and colours.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

using Color = std::array<double, 3>;  // red, green and blue as screens have them (sRGB), in [0, 1]
constexpr Color kWhite{1, 1, 1};

// Rows of RGBA bytes, top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

// The colour of a picture on white paper at (u, v): u to the right and v upwards, the whole picture is [0, 1] x [0, 1]
// and repeats beyond. The pixel itself, not blended with those beside it: in textures they often belong to another
// place. White for a picture without pixels. O(1).
Color color_at(const Picture& picture, const Vec2& uv);

Color product(const Color& a, const Color& b);  // of each channel: what a tint makes of a colour

// Linear light, as glTF and renderers count it, as screens have it; outside [0, 1] the nearest within.
Color from_linear(const Color& linear);

// "#1a2b3c", each channel rounded to a byte, and back: exactly this form, nothing else.
std::string hex_text(const Color& color);
std::optional<Color> parse_hex(std::string_view text);

}  // namespace plico
