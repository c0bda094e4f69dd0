#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace {

// value = 0.d1 d2 d3 ... * 10^point
struct Decimal {
  std::string digits;
  int point = 0;
};

// fmt knows the shortest digits; how it sets them out is taken apart again.
Decimal shortest(double positive) {
  const std::string text = fmt::format("{}", positive);
  const std::size_t e = std::min(text.find('e'), text.size());
  const std::string mantissa = text.substr(0, e);
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  Decimal result;
  result.point = static_cast<int>(dot) + (e < text.size() ? std::atoi(text.c_str() + e + 1) : 0);
  result.digits = mantissa.substr(0, dot) + (dot < mantissa.size() ? mantissa.substr(dot + 1) : "");
  const std::size_t zeros = result.digits.find_first_not_of('0');
  result.digits.erase(0, zeros);
  result.point -= static_cast<int>(zeros);
  result.digits.erase(result.digits.find_last_not_of('0') + 1);
  return result;
}

std::string scientific(const Decimal& decimal) {
  std::string text(1, decimal.digits[0]);
  if (decimal.digits.size() > 1) text += "." + decimal.digits.substr(1);
  const int exponent = decimal.point - 1;
  return text + fmt::format("e{}{:02}", exponent < 0 ? '-' : '+', std::abs(exponent));
}

std::string fixed(const Decimal& decimal, double positive) {
  const int n = static_cast<int>(decimal.digits.size());
  if (decimal.point >= n) return fmt::format("{:.0f}", positive);  // whole: all its digits, exactly
  if (decimal.point > 0) return decimal.digits.substr(0, decimal.point) + "." + decimal.digits.substr(decimal.point);
  return "0." + std::string(-decimal.point, '0') + decimal.digits;
}

// How long fixed() would be; numbers can have 300 digits.
int fixed_length(const Decimal& decimal) {
  const int n = static_cast<int>(decimal.digits.size());
  return decimal.point >= n ? decimal.point : decimal.point > 0 ? n + 1 : n + 2 - decimal.point;
}

std::string text_of(double positive) {
  if (std::isnan(positive)) return "nan";
  if (std::isinf(positive)) return "inf";
  if (positive == 0) return "0";
  const Decimal decimal = shortest(positive);
  const std::string long_way = scientific(decimal);
  return fixed_length(decimal) <= static_cast<int>(long_way.size()) ? fixed(decimal, positive) : long_way;
}

}  // namespace

std::to_chars_result std::to_chars(char* first, char* last, double value) {
  const std::string text = (std::signbit(value) ? "-" : "") + text_of(std::abs(value));
  if (last - first < static_cast<std::ptrdiff_t>(text.size())) return {last, errc::value_too_large};
  std::memcpy(first, text.data(), text.size());
  return {first + text.size(), {}};
}
