// Bytes as text in the alphabet of RFC 4648, section 4.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plico {

std::string base64(std::string_view bytes);
std::optional<std::string> decoded_base64(std::string_view text);  // nothing when some letter is not of the alphabet

}  // namespace plico
