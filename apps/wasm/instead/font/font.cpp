// Instead of cairo: the letters of a table that was made with it, so that both builds draw the same.
#include "plico/font/font.h"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>

namespace plico {
namespace {

constexpr double kEm = 1000;
constexpr double kUnit = 256;  // cairo's fixed point: this many to a unit of the table's em

struct TableRow {
  char32_t code;
  double advance;
  const char* outlines;  // "x y x y;x y ...": in 1/256, y downwards
};
constexpr TableRow kTable[] = {
#include "glyph_table.inc"
};

struct Glyph {
  double advance = 0;
  std::vector<std::vector<std::pair<long, long>>> outlines;
};

Glyph glyph_of(const TableRow& row) {
  Glyph glyph{row.advance, {}};
  for (const char* at = row.outlines; *at;) {
    if (at == row.outlines || *at == ';') glyph.outlines.emplace_back(), at += *at == ';';
    char* end = nullptr;
    const long x = std::strtol(at, &end, 10);
    const long y = std::strtol(end, &end, 10);
    glyph.outlines.back().emplace_back(x, y);
    for (at = end; *at == ' ';) ++at;
  }
  return glyph;
}

// The next code point of UTF-8 text; a broken byte is a question mark.
char32_t next_code(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
  if (length == 0 || length > text.size()) {
    text.remove_prefix(1);
    return U'?';
  }
  char32_t code = length == 1 ? first : first & (0x7f >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3f);
  text.remove_prefix(length);
  return code;
}

}  // namespace

struct Font::Face {
  std::map<char32_t, Glyph> glyphs;
  Face() {
    for (const TableRow& row : kTable) glyphs.emplace(row.code, glyph_of(row));
  }
  const Glyph& operator[](char32_t code) const {
    const auto found = glyphs.find(code);
    return found == glyphs.end() ? glyphs.at(U'?') : found->second;
  }
};

Font::Font() : face_(std::make_unique<Face>()) {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

double Font::width(std::string_view text, double size) const {
  double advance = 0;
  while (!text.empty()) advance += (*face_)[next_code(text)].advance;
  return advance / kEm * size;
}

std::vector<std::vector<Vec2>> Font::outlines(std::string_view text, double size) const {
  std::vector<std::vector<Vec2>> result;
  double advance = 0;
  while (!text.empty()) {
    const Glyph& glyph = (*face_)[next_code(text)];
    const double start = std::nearbyint(advance * kUnit);
    for (const auto& outline : glyph.outlines) {
      result.emplace_back();
      for (const auto& [x, y] : outline)
        result.back().emplace_back((start + static_cast<double>(x)) / kUnit / kEm * size,
                                   -(static_cast<double>(y) / kUnit) / kEm * size);
    }
    advance += glyph.advance;
  }
  return result;
}

}  // namespace plico
