#include "plico/io/text/zip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <limits>

#include "plico/base/error.h"
#include "plico/io/text/deflate.h"

namespace plico {
namespace {

constexpr std::uint16_t kVersion = 20, kDeflated = 8, kNamesInUtf8 = 0x800;
constexpr std::uint16_t kMidnight = 0, kFirstDay = 0x21;  // of 1980, where the format's time begins

void append_little_endian(std::string& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

std::uint32_t narrow(std::size_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw InvalidInput("write/range",
                       fmt::format("{} bytes are more than the 4294967295 that a ZIP archive counts to", size));
  return static_cast<std::uint32_t>(size);
}

// A stream without its two bytes before and the checksum behind.
std::string deflated(const std::string& bytes) {
  const std::string stream = zlib_stream(bytes);
  return stream.substr(2, stream.size() - 6);
}

// What stands both before each file and in the directory at the end.
std::string entry(const std::string& name, const std::string& content, std::size_t packed) {
  std::string bytes;
  for (std::uint16_t word : {kVersion, kNamesInUtf8, kDeflated, kMidnight, kFirstDay})
    append_little_endian(bytes, word, 2);
  append_little_endian(bytes, crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()), 4);
  append_little_endian(bytes, narrow(packed), 4);
  append_little_endian(bytes, narrow(content.size()), 4);
  append_little_endian(bytes, name.size(), 2);
  append_little_endian(bytes, 0, 2);  // nothing extra
  return bytes;
}

}  // namespace

std::string write_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string archive, directory;
  for (const auto& [name, content] : files) {
    const std::string packed = deflated(content), told = entry(name, content, packed.size());
    directory += "PK\1\2";
    append_little_endian(directory, kVersion, 2);
    directory += told;
    append_little_endian(directory, 0, 2 + 2 + 2 + 4);  // comment, disk, attributes
    append_little_endian(directory, narrow(archive.size()), 4);
    directory += name;
    archive += "PK\3\4" + told + name + packed;
  }
  const std::uint32_t start = narrow(archive.size());
  archive += directory + "PK\5\6";
  append_little_endian(archive, 0, 4);  // disks
  append_little_endian(archive, files.size(), 2);
  append_little_endian(archive, files.size(), 2);
  append_little_endian(archive, directory.size(), 4);
  append_little_endian(archive, start, 4);
  append_little_endian(archive, 0, 2);  // comment
  return archive;
}

}  // namespace plico
