#include "plico/io/page/pdf_objects.h"

#include <fmt/format.h>

#include "plico/io/text/deflate.h"

namespace plico {
namespace {

constexpr int kMostEffort = 9;

// How many bytes the character takes that begins with this byte; 0 when none does.
std::size_t utf8_length(unsigned char first) {
  return first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
}

}  // namespace

int PdfObjects::add(std::string body) {
  bodies_.push_back(std::move(body));
  return static_cast<int>(bodies_.size());
}

void PdfObjects::set(int number, std::string body) { bodies_[number - 1] = std::move(body); }

int PdfObjects::add_stream(std::string_view entries, std::string_view content) {
  const std::string packed = zlib_stream(content, kMostEffort);
  return add(
      fmt::format("<< {} /Filter /FlateDecode /Length {} >>\nstream\n{}\nendstream", entries, packed.size(), packed));
}

std::string PdfObjects::written(int catalog, int information) const {
  std::string file = "%PDF-1.5\n%\xc2\xb5\xc2\xb6\n";  // bytes above 127 in a comment: the file is not text
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", bodies_.size() + 1);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, bodies_[i]);
  }
  const std::size_t table_at = file.size();
  file += table + fmt::format("trailer\n<< /Size {} /Root {} /Info {} >>\nstartxref\n{}\n%%EOF\n", bodies_.size() + 1,
                              pdf_reference(catalog), pdf_reference(information), table_at);
  return file;
}

std::string pdf_reference(int number) { return fmt::format("{} 0 R", number); }

std::string pdf_references(const std::vector<int>& numbers) {
  std::string text;
  for (int number : numbers) text += (text.empty() ? "" : " ") + pdf_reference(number);
  return "[" + text + "]";
}

std::string pdf_text(std::string_view utf8) {
  std::string text = "<FEFF";
  for (char32_t code : code_points(utf8)) text += utf16_hex(code);
  return text + ">";
}

std::vector<char32_t> code_points(std::string_view utf8) {
  std::vector<char32_t> codes;
  while (!utf8.empty()) {
    const auto first = static_cast<unsigned char>(utf8.front());
    const std::size_t length = utf8_length(first);
    if (length == 0 || length > utf8.size()) {
      codes.push_back(U'?');
      utf8.remove_prefix(1);
      continue;
    }
    char32_t code = length == 1 ? first : first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(utf8[i]) & 0x3f);
    codes.push_back(code);
    utf8.remove_prefix(length);
  }
  return codes;
}

std::string utf16_hex(char32_t code) {
  const auto number = static_cast<unsigned>(code);
  if (number < 0x10000) return fmt::format("{:04X}", number);
  return fmt::format("{:04X}{:04X}", 0xd800 + ((number - 0x10000) >> 10), 0xdc00 + ((number - 0x10000) & 0x3ff));
}

}  // namespace plico
