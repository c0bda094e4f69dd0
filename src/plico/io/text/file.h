// Bytes in and out. "-" is standard input or output. A file is written to a temporary name beside it and renamed, so on
// any failure nothing half-written remains.
#pragma once
#include <string>
#include <string_view>

namespace plico {

// The whole file. Throws FileError when it cannot be read or has more than `max_bytes`.
std::string read_file(const std::string& path, std::size_t max_bytes = std::size_t{1} << 30);

// Throws FileError when `path` exists and `overwrite` is false, or when it cannot be written; it is then as it was
// before. What is no file but a device or a pipe is written to as it is.
void write_file(const std::string& path, std::string_view bytes, bool overwrite = false);

// Whether something is there that is neither a file nor a folder.
bool is_device(const std::string& path);

// The extension in lower case without its dot; empty for none and for "-".
std::string extension(const std::string& path);

}  // namespace plico
