#include "plico/base/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

double channel_from_linear(double light) {
  light = light > 0 ? std::min(light, 1.0) : 0;  // not a number is dark
  return light <= 0.0031308 ? 12.92 * light : 1.055 * plico::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace

Color color_at(const Picture& picture, const Vec2& uv) {
  if (picture.width < 1 || picture.height < 1 || !uv.allFinite()) return kWhite;
  const auto place = [](double share, int size) { return std::min(static_cast<int>(share * size), size - 1); };
  const int column = place(uv.x() - std::floor(uv.x()), picture.width);
  const int row = picture.height - 1 - place(uv.y() - std::floor(uv.y()), picture.height);
  const std::uint8_t* pixel = picture.rgba.data() + std::size_t{4} * (std::size_t(row) * picture.width + column);
  const double alpha = pixel[3] / 255.0;
  Color color;
  for (std::size_t k = 0; k < 3; ++k) color[k] = 1 - alpha + alpha * pixel[k] / 255.0;
  return color;
}

Color product(const Color& a, const Color& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

Color from_linear(const Color& linear) {
  return {channel_from_linear(linear[0]), channel_from_linear(linear[1]), channel_from_linear(linear[2])};
}

std::string hex_text(const Color& color) {
  const auto byte = [](double x) { return static_cast<int>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color[0]), byte(color[1]), byte(color[2]));
}

std::optional<Color> parse_hex(std::string_view text) {
  unsigned number = 0;
  if (text.size() != 7 || text[0] != '#') return {};
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, number, 16);
  if (error != std::errc() || end != text.data() + 7) return {};
  return Color{(number >> 16 & 255) / 255.0, (number >> 8 & 255) / 255.0, (number & 255) / 255.0};
}

}  // namespace plico
