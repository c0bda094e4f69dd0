// Fixed-size numbers in binary files, in either byte order.
#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace plico {

// The Number stored at `at`, which must have sizeof(Number) bytes left.
template <class Number>
Number load_number(std::string_view bytes, std::size_t at, std::endian order = std::endian::little) {
  char raw[sizeof(Number)];
  for (std::size_t i = 0; i < sizeof raw; ++i)
    raw[i] = bytes[at + (order == std::endian::native ? i : sizeof raw - 1 - i)];
  Number number;
  std::memcpy(&number, raw, sizeof raw);
  return number;
}

template <class Number>
void append_number(std::string& bytes, Number number, std::endian order = std::endian::little) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof raw);
  for (std::size_t i = 0; i < sizeof raw; ++i)
    bytes.push_back(raw[order == std::endian::native ? i : sizeof raw - 1 - i]);
}

}  // namespace plico
