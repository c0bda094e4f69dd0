#include "plico/io/text/png.h"

#include <zlib.h>

#include "plico/base/error.h"
#include "plico/io/text/deflate.h"

namespace plico {
namespace {

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}

// Length, name and content, checksum over the last two.
void append_chunk(std::string& png, const std::string& name, const std::string& content) {
  append_big_endian(png, static_cast<std::uint32_t>(content.size()));
  const std::string body = name + content;
  png += body;
  append_big_endian(png, static_cast<std::uint32_t>(
                             crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
}

// Every row as differences to the row above (filter 2): smooth pictures compress to a fraction.
std::string filtered_rows(const Picture& picture) {
  const std::size_t row = std::size_t{4} * picture.width;
  std::string bytes;
  bytes.reserve((row + 1) * picture.height);
  for (int y = 0; y < picture.height; ++y) {
    bytes += y ? '\2' : '\0';
    const std::uint8_t* at = picture.rgba.data() + y * row;
    for (std::size_t i = 0; i < row; ++i) bytes += static_cast<char>(y ? at[i] - (at - row)[i] : at[i]);
  }
  return bytes;
}

}  // namespace

std::string write_png(const Picture& picture, int effort) {
  PLICO_ASSERT(picture.rgba.size() == std::size_t{4} * picture.width * picture.height);
  std::string png = "\x89PNG\r\n\x1a\n", header;
  append_big_endian(header, static_cast<std::uint32_t>(picture.width));
  append_big_endian(header, static_cast<std::uint32_t>(picture.height));
  header += std::string("\x08\x06\x00\x00\x00", 5);  // 8 bits, RGBA, standard compression and filters, not interlaced
  append_chunk(png, "IHDR", header);
  append_chunk(png, "IDAT", zlib_stream(filtered_rows(picture), effort));
  append_chunk(png, "IEND", "");
  return png;
}

}  // namespace plico
