// The letters of a PDF file: fonts that hold the outlines of what is written and nothing else, as text that can be
// searched and copied. The outlines are those of `Font`, so a file looks the same wherever it was made.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "plico/io/page/drawing.h"
#include "plico/io/page/pdf_objects.h"

namespace plico {

class PdfLetters {
 public:
  // Adds the fonts for all texts of `pages` to `objects`.
  PdfLetters(const std::vector<Drawing>& pages, PdfObjects& objects);

  const std::string& fonts() const { return fonts_; }  // the dictionary for a page's resources
  // Operators that show a text at the current text position, `size` the em.
  std::string shown(std::string_view text, double size) const;

 private:
  void add_font(const std::vector<char32_t>& letters, PdfObjects& objects);

  struct Place {
    int font = 0, code = 0;
  };
  std::map<char32_t, Place> places_;
  int num_fonts_ = 0;
  std::string fonts_;
};

}  // namespace plico
