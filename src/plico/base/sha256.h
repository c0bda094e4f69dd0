// SHA-256 (FIPS 180-4), to name an input in a report; not for secrets.
#pragma once
#include <string>
#include <string_view>

namespace plico {

// 64 lower-case hexadecimal digits. O(bytes), some 300 MB/s.
std::string sha256(std::string_view bytes);

}  // namespace plico
