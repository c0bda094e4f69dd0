// The numbered objects of a PDF file, and the table at its end that says where each begins.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plico {

class PdfObjects {
 public:
  // The number of a new object; without a body it is set() later.
  int add(std::string body = {});
  void set(int number, std::string body);
  // `entries` of its dictionary beside those that say how long it is and how it is compressed.
  int add_stream(std::string_view entries, std::string_view content);

  std::string written(int catalog, int information) const;

 private:
  std::vector<std::string> bodies_;  // of object 1, 2, ...
};

std::string pdf_reference(int number);                        // "12 0 R"
std::string pdf_references(const std::vector<int>& numbers);  // "[12 0 R 13 0 R]"
std::string pdf_text(std::string_view utf8);                  // a text string in UTF-16, in angle brackets

// The code points of UTF-8 text; a broken byte is a question mark.
std::vector<char32_t> code_points(std::string_view utf8);
std::string utf16_hex(char32_t code);  // big-endian, 4 or 8 digits

}  // namespace plico
