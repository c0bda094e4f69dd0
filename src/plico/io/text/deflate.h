// Bytes made smaller by zlib, for the formats that hold such streams.
#pragma once
#include <string>
#include <string_view>

namespace plico {

// A zlib stream (RFC 1950) of the bytes; `effort` is zlib's, 1 to 9, or -1 for its usual. The same on every machine.
std::string zlib_stream(std::string_view bytes, int effort = -1);

}  // namespace plico
