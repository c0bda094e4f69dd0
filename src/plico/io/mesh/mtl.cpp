#include "plico/io/mesh/mtl.h"

#include <algorithm>

#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

// The first word of `text`, taken off.
std::string_view next_word(std::string_view& text) {
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t", first), text.size());
  const std::string_view word = text.substr(first, end - first);
  text.remove_prefix(std::min(text.find_first_not_of(" \t", end), text.size()));
  return word;
}

// How many words follow an option of a picture; -1 for a word that is none.
int words_after(std::string_view option) {
  if (option == "-mm") return 2;
  for (const char* one : {"-blendu", "-blendv", "-cc", "-clamp", "-boost", "-texres", "-bm", "-imfchan", "-type"})
    if (option == one) return 1;
  return -1;
}

// Up to three numbers, of which the first two count; a single one is that of u.
void take_numbers(std::string_view& text, Vec2& value) {
  for (int axis = 0; axis < 3; ++axis) {
    std::string_view rest = text;
    double number = 0;
    if (!parse_number(next_word(rest), number)) return;
    if (axis < 2) value[axis] = number;
    text = rest;
  }
}

class MtlReader {
 public:
  MtlReader(std::string_view bytes, const std::string& name) : scan_(bytes, name) {}

  std::vector<Material> read() {
    while (scan_.more()) {
      const std::string_view keyword = scan_.word();
      if (keyword == "newmtl") {
        materials_.push_back({.name = std::string(scan_.rest_of_line())});
      } else if (keyword == "Kd" && !materials_.empty()) {
        read_color();
      } else if (keyword == "map_Kd" && !materials_.empty()) {
        read_picture_name();
      }
      scan_.skip_line();
    }
    return std::move(materials_);
  }

 private:
  void read_color() {
    Color color{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!scan_.more_on_line()) {
        if (k != 1) scan_.fail("read/syntax", "Kd needs three numbers");
        color[2] = color[1] = color[0];  // one number stands for three
        break;
      }
      const std::string_view word = scan_.word();
      if (k == 0 && (word == "spectral" || word == "xyz")) return;  // no program writes them
      if (!parse_number(word, color[k]) || !(color[k] >= 0))
        scan_.fail("read/number", "a colour is " + quoted_word(word) + ", must be a number in [0, 1]");
    }
    for (std::size_t k = 0; k < 3; ++k) materials_.back().color[k] = std::min(color[k], 1.0);
  }

  void read_picture_name() {
    std::string_view rest = scan_.rest_of_line();
    Material& material = materials_.back();
    while (rest.starts_with('-')) {
      std::string_view after = rest;
      const std::string_view option = next_word(after);
      if (option == "-s") {
        take_numbers(after, material.scale);
      } else if (option == "-o") {
        take_numbers(after, material.offset);
      } else if (option == "-t") {
        Vec2 unused;
        take_numbers(after, unused);
      } else if (const int words = words_after(option); words > 0) {
        for (int i = 0; i < words; ++i) next_word(after);
      } else {
        break;  // the name of a file
      }
      rest = after;
    }
    if (rest.size() > 1 && rest.front() == '"' && rest.back() == '"') rest = rest.substr(1, rest.size() - 2);
    material.picture = rest;
  }

  TextScanner scan_;
  std::vector<Material> materials_;
};

}  // namespace

std::vector<Material> read_mtl(std::string_view bytes, const std::string& name) {
  return MtlReader(bytes, name).read();
}

}  // namespace plico
