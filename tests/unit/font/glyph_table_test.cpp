// The letters that the WebAssembly build draws with are those that cairo draws natively.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "plico/font/font.h"

namespace plico {
namespace {

std::string utf8(unsigned code) {
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 0x3f))};
  return {static_cast<char>(0xe0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3f)),
          static_cast<char>(0x80 | (code & 0x3f))};
}

std::string row(const Font& font, unsigned code) {
  constexpr double kEm = 1000, kUnit = 256;  // of cairo's fixed point
  std::string outlines;
  for (const auto& outline : font.outlines(utf8(code), kEm)) {
    if (!outlines.empty()) outlines += ';';
    for (std::size_t i = 0; i < outline.size(); ++i)
      outlines += fmt::format("{}{} {}", i ? " " : "", std::lround(outline[i].x() * kUnit),
                              std::lround(-outline[i].y() * kUnit));
  }
  return fmt::format("{{{}, {}, \"{}\"}},\n", code, font.width(utf8(code), kEm), outlines);
}

std::string table() {
  const Font font;
  std::string text;
  for (unsigned code = 32; code < 127; ++code) text += row(font, code);
  for (unsigned code = 160; code < 256; ++code) text += row(font, code);
  for (unsigned code : {0x2013u, 0x2014u, 0x2026u}) text += row(font, code);  // dashes and dots
  return text;
}

TEST(GlyphTable, IsWhatCairoDraws) {
  std::ifstream file(PLICO_GLYPH_TABLE);
  std::stringstream kept;
  kept << file.rdbuf();
  const std::string made = table();
  if (made != kept.str()) std::ofstream("glyph_table.inc") << made;
  EXPECT_TRUE(made == kept.str()) << "the table as it should be is now in glyph_table.inc of this folder";
}

}  // namespace
}  // namespace plico
