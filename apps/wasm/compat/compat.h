// What the C++20 standard library of emscripten 3.1.6 lacks and Plico uses, included first in every source of the wasm
// build. Goes when the toolchain moves on.
#pragma once
#ifdef __cplusplus
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// There are no threads: asking for one fails, as it may on any system.
class jthread {
 public:
  template <class F>
  explicit jthread(F&&) {
    throw system_error(make_error_code(errc::resource_unavailable_try_again));
  }
};

namespace ranges {

template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return find_if(begin(range), end(range), [&](const auto& x) { return invoke(projection, x) == value; });
}
template <class Range, class Predicate, class Projection = identity>
auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(begin(range), end(range),
                      [&](const auto& x) -> bool { return invoke(predicate, invoke(projection, x)); });
}
template <class Range, class Others>
auto find_first_of(Range&& range, Others&& others) {
  return std::find_first_of(begin(range), end(range), begin(others), end(others));
}
template <class Range, class Value, class Projection = identity>
auto count(Range&& range, const Value& value, Projection projection = {}) {
  return std::count_if(begin(range), end(range), [&](const auto& x) { return invoke(projection, x) == value; });
}
template <class Range, class Predicate>
auto count_if(Range&& range, Predicate predicate) {
  return std::count_if(begin(range), end(range), [&](const auto& x) -> bool { return invoke(predicate, x); });
}
template <class Range, class Predicate>
bool all_of(Range&& range, Predicate predicate) {
  return std::all_of(begin(range), end(range), [&](const auto& x) -> bool { return invoke(predicate, x); });
}
template <class Range, class Predicate>
bool any_of(Range&& range, Predicate predicate) {
  return std::any_of(begin(range), end(range), [&](const auto& x) -> bool { return invoke(predicate, x); });
}
template <class Range>
auto max(const Range& range) {
  return *std::max_element(begin(range), end(range));
}
template <class Range>
auto min(const Range& range) {
  return *std::min_element(begin(range), end(range));
}
template <class Range>
auto minmax(const Range& range) {
  const auto [low, high] = std::minmax_element(begin(range), end(range));
  return std::pair(*low, *high);
}
template <class Range, class Compare = std::less<>, class Projection = identity>
auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(begin(range), end(range), [&](const auto& a, const auto& b) -> bool {
    return invoke(compare, invoke(projection, a), invoke(projection, b));
  });
}
template <class Range, class Other>
bool equal(Range&& range, Other&& other) {
  return std::equal(begin(range), end(range), begin(other), end(other));
}
// Both ends, as a range.
template <class Iterator>
struct Between {
  Iterator first, last;
  Iterator begin() const { return first; }
  Iterator end() const { return last; }
};
template <class Range, class Value>
auto equal_range(Range&& range, const Value& value) {
  const auto [first, last] = std::equal_range(begin(range), end(range), value);
  return Between<std::decay_t<decltype(first)>>{first, last};
}
template <class Range, class Output>
void move(Range&& range, Output output) {
  std::move(begin(range), end(range), output);
}
template <class Range>
void reverse(Range&& range) {
  std::reverse(begin(range), end(range));
}
template <class Range, class Output, class Function>
void transform(Range&& range, Output output, Function function) {
  std::transform(begin(range), end(range), output, function);
}

template <class Range, class Compare = std::less<>, class Projection = identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(begin(range), end(range), [&](const auto& a, const auto& b) -> bool {
    return invoke(compare, invoke(projection, a), invoke(projection, b));
  });
}
template <class Range, class Compare = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(begin(range), end(range), [&](const auto& a, const auto& b) -> bool {
    return invoke(compare, invoke(projection, a), invoke(projection, b));
  });
}

}  // namespace ranges

// Decimal only, as the standard has it: no blanks before, no plus, no 0x.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* digits = first != last && *first == '-' ? first + 1 : first;
  if (digits == last || !(isdigit(*digits) || *digits == '.' || isalpha(*digits)))
    return {first, errc::invalid_argument};
  if (last - digits > 1 && digits[0] == '0' && (digits[1] | 0x20) == 'x') {
    value = *first == '-' ? -0.0 : 0.0;
    return {digits + 1, {}};
  }
  const string text(first, last);  // strtod wants an end
  char* end = nullptr;
  errno = 0;
  const double number = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  const char* stop = first + (end - text.c_str());
  if (errno == ERANGE) return {stop, errc::result_out_of_range};
  value = number;
  return {stop, {}};
}

// The fewest digits that read back as `value`, in the shorter of the two notations.
to_chars_result to_chars(char* first, char* last, double value);

}  // namespace std
#endif
