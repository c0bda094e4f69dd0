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

[[noreturn]] void refuse_to_read(const std::string& path, const std::string& why, const std::string& suggestion = {}) {
  throw FileError("file/read", fmt::format("cannot read {}: {}", path, why), path, suggestion);
}

[[noreturn]] void refuse_to_write(const std::string& path, int error) {
  throw FileError("file/write", fmt::format("cannot write {}: {}", path, std::strerror(error)), path,
                  error == ENOSPC || error == EDQUOT ? "df -h shows what is full" : "");
}

void write_all(std::FILE* f, std::string_view bytes, const std::string& path) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), f) != bytes.size() || std::fflush(f) != 0)
    refuse_to_write(path, errno);
}

void write_to(const std::string& path, std::string_view bytes, const std::string& as) {
  const File f(std::fopen(as.c_str(), "wb"));
  if (!f) refuse_to_write(path, errno);
  write_all(f.get(), bytes, path);
}

}  // namespace

std::string read_file(const std::string& path, std::size_t max_bytes) {
  const bool standard = path == "-";
  std::error_code error;
  if (!standard && std::filesystem::is_directory(path, error))
    refuse_to_read(path, "it is a folder", "name a file of it");
  File owned(standard ? nullptr : std::fopen(path.c_str(), "rb"));
  std::FILE* f = standard ? stdin : owned.get();
  if (!f) refuse_to_read(path, std::strerror(errno));
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, f)) {
    bytes.append(buffer, n);
    if (bytes.size() > max_bytes)
      throw FileError("file/too-large", fmt::format("{} has more than {} bytes", path, max_bytes), path);
  }
  if (std::ferror(f)) refuse_to_read(path, std::strerror(errno));
  return bytes;
}

void write_file(const std::string& path, std::string_view bytes, bool overwrite) {
  if (path == "-") return write_all(stdout, bytes, "standard output");
  std::error_code error;
  if (is_device(path)) return write_to(path, bytes, path);
  if (!overwrite && std::filesystem::exists(path, error))
    throw FileError("file/exists", fmt::format("{} exists already", path), path, "add --force to overwrite it");
  const std::string temporary = fmt::format("{}.{}.part", path, getpid());
  try {
    write_to(path, bytes, temporary);
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  std::filesystem::rename(temporary, path, error);
  if (!error) return;
  const int reason = error.value();
  std::filesystem::remove(temporary, error);
  refuse_to_write(path, reason);
}

bool is_device(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

std::string extension(const std::string& path) {
  const auto dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string ext = path.substr(dot + 1);
  std::transform(ext.begin(), ext.end(), ext.begin(), [](unsigned char c) { return std::tolower(c); });
  return ext;
}

}  // namespace plico
