#include "plico/io/text/file.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "plico/base/error.h"

namespace plico {
namespace {

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

void write_all(std::FILE* f, std::string_view bytes, const std::string& path) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), f) != bytes.size() || std::fflush(f) != 0)
    throw FileError("file/write", fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

}  // namespace

std::string read_file(const std::string& path, std::size_t max_bytes) {
  const bool standard = path == "-";
  std::error_code error;
  if (!standard && std::filesystem::is_directory(path, error))
    throw FileError("file/read", fmt::format("cannot read {}: it is a folder", path));
  File owned(standard ? nullptr : std::fopen(path.c_str(), "rb"));
  std::FILE* f = standard ? stdin : owned.get();
  if (!f) throw FileError("file/read", fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, f)) {
    bytes.append(buffer, n);
    if (bytes.size() > max_bytes)
      throw FileError("file/too-large", fmt::format("{} has more than {} bytes", path, max_bytes));
  }
  if (std::ferror(f)) throw FileError("file/read", fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  return bytes;
}

void write_file(const std::string& path, std::string_view bytes, bool overwrite) {
  if (path == "-") return write_all(stdout, bytes, "standard output");
  std::error_code error;
  if (!overwrite && std::filesystem::exists(path, error))
    throw FileError("file/exists", fmt::format("{} exists already", path), {}, "add --force to overwrite it");
  const std::string temporary = fmt::format("{}.{}.part", path, getpid());
  try {
    File f(std::fopen(temporary.c_str(), "wb"));
    if (!f) throw FileError("file/write", fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    write_all(f.get(), bytes, path);
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  std::filesystem::rename(temporary, path, error);
  if (!error) return;
  const std::string reason = error.message();
  std::filesystem::remove(temporary, error);
  throw FileError("file/write", fmt::format("cannot write {}: {}", path, reason));
}

std::string extension(const std::string& path) {
  const auto dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string ext = path.substr(dot + 1);
  std::transform(ext.begin(), ext.end(), ext.begin(), [](unsigned char c) { return std::tolower(c); });
  return ext;
}

}  // namespace plico
