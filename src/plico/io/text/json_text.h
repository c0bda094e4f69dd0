// JSON written by hand: arrays of a hundred thousand rows go to text without a tree of values in between.
#pragma once
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "plico/base/error.h"
#include "plico/base/vec.h"

namespace plico {

// Appends to one string. Objects have one key a line; the rows of an array are wrapped at about 120 columns.
class JsonText {
 public:
  void open() {
    out_ += '{';
    first_key_ = true;
  }
  void close() {
    out_ += "\n}";
    first_key_ = false;
  }
  void key(std::string_view name) { quoted_key(fmt::format("\"{}\"", name)); }  // of plain letters
  void quoted_key(std::string_view name) {
    out_ += first_key_ ? "\n" : ",\n";
    first_key_ = false;
    line_ = out_.size();
    out_ += name;
    out_ += ':';
  }
  void raw(std::string_view json) { out_ += json; }

  // One row per element of `range`, each written by `write(element)`.
  template <class Range, class Write>
  void list(const Range& range, Write write) {
    out_ += '[';
    bool first = true;
    for (const auto& element : range) {
      if (!first) out_ += ',';
      if (out_.size() - line_ > kColumns) new_line();
      first = false;
      write(element);
    }
    out_ += ']';
  }

  void integer(int value) {
    char digits[16];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }
  // The shortest text that reads back as the same double; minus zero is written as zero.
  void number(double value) {
    PLICO_ASSERT(std::isfinite(value));
    char digits[32];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, value + 0.0).ptr);
  }
  void point(const Vec2& p) {
    out_ += '[';
    number(p.x());
    out_ += ',';
    number(p.y());
    out_ += ']';
  }
  void point(const Vec3& p) {
    out_ += '[';
    number(p.x());
    out_ += ',';
    number(p.y());
    out_ += ',';
    number(p.z());
    out_ += ']';
  }
  std::string take() { return std::move(out_); }

 private:
  static constexpr std::size_t kColumns = 110;  // a row is added before the line is that long
  void new_line() {
    out_ += '\n';
    line_ = out_.size();
  }

  std::string out_;
  std::size_t line_ = 0;  // where the current line starts
  bool first_key_ = true;
};

}  // namespace plico
