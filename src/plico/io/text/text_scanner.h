// Words and numbers of a text file with the line they stand on. The same in every locale.
#pragma once
#include <string>
#include <string_view>

namespace plico {

// Reads forwards through `bytes`, which must outlive it. '#' starts a comment; a backslash before the line's end joins
// it with the next; lines end with LF, CRLF or CR.
class TextScanner {
 public:
  // Throws InvalidInput when there is a zero byte: no text has one.
  TextScanner(std::string_view bytes, std::string name);

  // Moves to the next word, on this line only or on any. False when there is none.
  bool more_on_line();
  bool more();

  std::string_view word();               // the next word on any line; fails at the end of the file
  double number(std::string_view what);  // `what` names the thing in messages: "the x of vertex 3"
  int integer(std::string_view what);
  void skip_line();  // to the end of this line
  // What is left of this line as it stands, without spaces around it: names may hold spaces and any sign.
  std::string_view rest_of_line();

  int line() const { return line_; }  // of the next character, from 1
  std::size_t position() const { return at_; }

  // Throws InvalidInput with "name:line" of the word read last.
  [[noreturn]] void fail(const std::string& code, const std::string& message, const std::string& suggestion = {}) const;

 private:
  bool at_line_end() const;
  bool at_joined_line() const;
  void pass_line_end();

  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1, word_line_ = 1;
};

// The whole word as a number; false when it is not one. A leading plus is allowed; nan and inf are numbers.
bool parse_number(std::string_view word, double& number);
bool parse_integer(std::string_view word, int& number);

// At most `max` characters of a word from a file, made printable.
std::string quoted_word(std::string_view word, std::size_t max = 24);

}  // namespace plico
