// The one font of a sheet: how large a text is, and its letters as outlines. The only place that knows cairo's text.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

class Font {
 public:
  static constexpr const char* kFamily = "DejaVu Sans";

  Font();
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  double width(std::string_view text, double size) const;  // advance; `size` is the em, any unit
  static double cap_height(double size) { return 0.729 * size; }

  // Closed outlines of the letters, the baseline starting at the origin, y upwards; holes are clockwise.
  std::vector<std::vector<Vec2>> outlines(std::string_view text, double size) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

constexpr double kMillimetresPerPoint = 25.4 / 72;

}  // namespace plico
