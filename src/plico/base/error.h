// Errors: input we cannot use, files we cannot reach, and bugs of ours.
// An outcome that nature allows (no net, no path) is never an error; it is an Ending (run.h).
#pragma once
#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace plico {

// Base of every error the library throws on purpose. A message is one sentence: lower-case start, no full stop, the
// value and its bound both shown. `where` says ids and coordinates, `suggestion` names one command to try.
class Error : public std::runtime_error {
 public:
  Error(std::string code, const std::string& message, std::string where, std::string suggestion)
      : std::runtime_error(message),
        code_(std::move(code)),
        where_(std::move(where)),
        suggestion_(std::move(suggestion)) {}

  const std::string& code() const { return code_; }  // stable, for programs: "mesh/edge-with-three-faces"
  const std::string& where() const { return where_; }
  const std::string& suggestion() const { return suggestion_; }

 private:
  std::string code_, where_, suggestion_;
};

// The input is readable but unusable: exit code 3.
struct InvalidInput : Error {
  InvalidInput(std::string code, const std::string& message, std::string where = {}, std::string suggestion = {})
      : Error(std::move(code), message, std::move(where), std::move(suggestion)) {}
};

// An option is out of range or does not fit the others: exit code 2.
struct InvalidOption : Error {
  explicit InvalidOption(const std::string& message, std::string suggestion = {})
      : Error("usage/option", message, {}, std::move(suggestion)) {}
};

// A file cannot be read or written: exit code 4.
struct FileError : Error {
  FileError(std::string code, const std::string& message, std::string where = {}, std::string suggestion = {})
      : Error(std::move(code), message, std::move(where), std::move(suggestion)) {}
};

// Throws InvalidOption unless the value `fits`: "faces = 3 must be at least 4". The range is told in words or as an
// interval, both shown in the unit of the option.
template <class T>
void require(bool fits, std::string_view option, const T& value, std::string_view range) {
  if (fits) return;
  if constexpr (std::is_floating_point_v<T>)
    throw InvalidOption(fmt::format("{} = {:.6g} must be {}", option, value, range));
  else
    throw InvalidOption(fmt::format("{} = {} must be {}", option, value, range));
}

// A bug of ours. Never caught inside the library.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace plico

// Cheap invariants; stays on in release builds.
#define PLICO_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::plico::assertion_failed(#condition, __FILE__, __LINE__))
