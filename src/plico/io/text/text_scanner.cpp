#include "plico/io/text/text_scanner.h"

#include <charconv>

#include "plico/base/error.h"

namespace plico {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_end(char c) { return c == '\n' || c == '\r'; }

template <class Number>
bool parse_all(std::string_view word, Number& number) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

bool parse_number(std::string_view word, double& number) { return parse_all(word, number); }
bool parse_integer(std::string_view word, int& number) { return parse_all(word, number); }

std::string quoted_word(std::string_view word, std::size_t max) {
  std::string text = "'";
  for (char c : word.substr(0, max)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > max ? "...'" : "'");
}

TextScanner::TextScanner(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
  const auto zero = bytes.find('\0');
  if (zero != std::string_view::npos)
    throw InvalidInput("read/binary", fmt::format("byte {} is zero, so this is a binary file read as text", zero),
                       fmt::format("{}: byte {}", name_, zero));
}

bool TextScanner::at_line_end() const { return at_ == bytes_.size() || is_end(bytes_[at_]); }

bool TextScanner::at_joined_line() const {
  return bytes_[at_] == '\\' && at_ + 1 < bytes_.size() && is_end(bytes_[at_ + 1]);
}

void TextScanner::pass_line_end() {
  at_ += bytes_[at_] == '\r' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n' ? 2 : 1;
  ++line_;
}

void TextScanner::skip_line() {
  while (at_ < bytes_.size() && !is_end(bytes_[at_])) ++at_;
  if (at_ < bytes_.size()) pass_line_end();
}

std::string_view TextScanner::rest_of_line() {
  word_line_ = line_;
  while (!at_line_end() && is_space(bytes_[at_])) ++at_;
  const std::size_t first = at_;
  while (!at_line_end()) ++at_;
  std::string_view rest = bytes_.substr(first, at_ - first);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

bool TextScanner::more_on_line() {
  while (!at_line_end()) {
    if (is_space(bytes_[at_])) {
      ++at_;
    } else if (at_joined_line()) {
      ++at_;
      pass_line_end();
    } else if (bytes_[at_] == '#') {
      while (!at_line_end()) ++at_;
    } else {
      return true;
    }
  }
  return false;
}

bool TextScanner::more() {
  while (!more_on_line()) {
    if (at_ == bytes_.size()) return false;
    pass_line_end();
  }
  return true;
}

std::string_view TextScanner::word() {
  if (!more()) {
    word_line_ = line_;
    fail("read/truncated", "the file ends too early");
  }
  word_line_ = line_;
  const std::size_t start = at_;
  do ++at_;
  while (!at_line_end() && !is_space(bytes_[at_]) && bytes_[at_] != '#' && !at_joined_line());
  return bytes_.substr(start, at_ - start);
}

double TextScanner::number(std::string_view what) {
  const std::string_view text = word();
  double value = 0;
  if (!parse_number(text, value))
    fail("read/number", fmt::format("{} is {}, must be a number that fits a double", what, quoted_word(text)));
  return value;
}

int TextScanner::integer(std::string_view what) {
  const std::string_view text = word();
  int value = 0;
  if (!parse_integer(text, value))
    fail("read/number", fmt::format("{} is {}, must be a whole number", what, quoted_word(text)));
  return value;
}

void TextScanner::fail(const std::string& code, const std::string& message, const std::string& suggestion) const {
  throw InvalidInput(code, message, fmt::format("{}:{}", name_, word_line_), suggestion);
}

}  // namespace plico
