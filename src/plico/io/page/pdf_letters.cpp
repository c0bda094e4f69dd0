#include "plico/io/page/pdf_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plico/font/font.h"

namespace plico {
namespace {

constexpr double kGlyphEm = 1000;
constexpr int kFirstCode = 33,
              kCodes = 256 - kFirstCode;  // of one font: none that viewers take for a line's end or space

std::string utf8_of(char32_t code) {
  const auto c = static_cast<unsigned>(code);
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3f)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xc0 | c >> 6), tail(0)};
  if (c < 0x10000) return {static_cast<char>(0xe0 | c >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xf0 | c >> 18), tail(12), tail(6), tail(0)};
}

// A letter is called by itself: readers of text guess the size of such a font by the width of its m.
std::string glyph_name(char32_t code) {
  const bool is_letter = (code >= U'a' && code <= U'z') || (code >= U'A' && code <= U'Z');
  return is_letter ? fmt::format("/{}", static_cast<char>(code)) : fmt::format("/u{:X}", static_cast<unsigned>(code));
}

// A hundred-thousandth of the em is enough, and hides the last bit of what the font was scaled by.
std::string rounded(double x) { return decimal(std::round(x * 100) / 100); }

struct GlyphShape {
  std::string width, drawing;
};

GlyphShape glyph_shape(const Font& font, char32_t code) {
  const std::string letter = utf8_of(code);
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  std::string path;
  for (const std::vector<Vec2>& outline : font.outlines(letter, kGlyphEm)) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      low = low.cwiseMin(outline[i]), high = high.cwiseMax(outline[i]);
      path += fmt::format("{} {} {}\n", rounded(outline[i].x()), rounded(outline[i].y()), i ? 'l' : 'm');
    }
    path += "h\n";
  }
  const std::string width = rounded(font.width(letter, kGlyphEm));
  return {width, fmt::format("{} 0 {} {} {} {} d1\n{}{}", width, rounded(low.x()), rounded(low.y()), rounded(high.x()),
                             rounded(high.y()), path, path.empty() ? "" : "f\n")};
}

// What the codes of a font mean, for search and copy.
std::string meaning(const std::vector<char32_t>& letters) {
  std::string map =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CMapName /Plico def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<00> <FF>\nendcodespacerange\n";
  constexpr std::size_t kBlock = 100;  // the most that one block may hold
  for (std::size_t start = 0; start < letters.size(); start += kBlock) {
    const std::size_t end = std::min(letters.size(), start + kBlock);
    map += fmt::format("{} beginbfchar\n", end - start);
    for (std::size_t i = start; i < end; ++i)
      map += fmt::format("<{:02X}> <{}>\n", kFirstCode + i, utf16_hex(letters[i]));
    map += "endbfchar\n";
  }
  return map + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

}  // namespace

PdfLetters::PdfLetters(const std::vector<Drawing>& pages, PdfObjects& objects) {
  std::set<char32_t> used;
  for (const Drawing& page : pages)
    for (const Text& text : page.texts)
      for (char32_t code : code_points(text.text)) used.insert(code);
  // Digits before full stops and spaces: without letters, readers guess by the first of all.
  const std::vector<char32_t> all(used.rbegin(), used.rend());
  for (std::size_t start = 0; start < all.size(); start += kCodes)
    add_font(
        {all.begin() + static_cast<long>(start), all.begin() + static_cast<long>(std::min(all.size(), start + kCodes))},
        objects);
  fonts_ = "<< " + fonts_ + ">>";
}

void PdfLetters::add_font(const std::vector<char32_t>& letters, PdfObjects& objects) {
  const Font font;
  std::string procedures, names, widths;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const GlyphShape shape = glyph_shape(font, letters[i]);
    const std::string called = glyph_name(letters[i]);
    procedures += fmt::format("{} {} ", called, pdf_reference(objects.add_stream("", shape.drawing)));
    names += " " + called;
    widths += " " + shape.width;
    places_[letters[i]] = {num_fonts_, kFirstCode + static_cast<int>(i)};
  }
  const int to_unicode = objects.add_stream("", meaning(letters));
  const int number = objects.add(fmt::format(
      "<< /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] /FontMatrix [0.001 0 0 0.001 0 0] /Resources << >>\n"
      "/CharProcs << {}>>\n/Encoding << /Type /Encoding /Differences [{}{}] >>\n"
      "/FirstChar {} /LastChar {} /Widths [{}]\n/ToUnicode {} >>",
      procedures, kFirstCode, names, kFirstCode, kFirstCode + letters.size() - 1, widths, pdf_reference(to_unicode)));
  fonts_ += fmt::format("/F{} {} ", num_fonts_++, pdf_reference(number));
}

std::string PdfLetters::shown(std::string_view text, double size) const {
  std::string result;
  int font = -1;
  for (char32_t code : code_points(text)) {
    const Place& place = places_.at(code);
    if (place.font != font) {
      result += fmt::format("{}/F{} {} Tf <", font < 0 ? "" : "> Tj ", place.font, decimal(size));
      font = place.font;
    }
    result += fmt::format("{:02X}", place.code);
  }
  return result.empty() ? result : result + "> Tj\n";
}

}  // namespace plico
