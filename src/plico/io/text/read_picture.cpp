#include "plico/io/text/read_picture.h"

#include <fmt/core.h>
#include <jpeglib.h>
#include <png.h>

#include <csetjmp>
#include <cstdio>

#include "plico/base/error.h"

namespace plico {
namespace {

void check_size(unsigned long width, unsigned long height, const std::string& name) {
  if (width > 0 && height > 0 && width <= kMostPictureSide && height <= kMostPictureSide &&
      width * height <= static_cast<unsigned long>(kMostPicturePixels))
    return;
  throw InvalidInput("picture/size",
                     fmt::format("the picture {} has {} x {} pixels, must have at most {} a side and {} in all", name,
                                 width, height, kMostPictureSide, kMostPicturePixels),
                     name);
}

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw InvalidInput("picture/damaged", fmt::format("the picture {} cannot be read: {}", name, why), name);
}

// Frees what libpng holds, however reading ends.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(this); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

Picture read_png(std::string_view bytes, const std::string& name) {
  PngImage png;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) fail(name, png.message);
  check_size(png.width, png.height, name);
  png.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, picture.rgba.data(), 0, nullptr)) fail(name, png.message);
  return picture;
}

// libjpeg tells of errors by a call that must not return.
struct JpegErrors {
  jpeg_error_mgr base;
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX];
};

void on_jpeg_error(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->message);
  std::longjmp(errors->back, 1);
}

void on_jpeg_message(j_common_ptr) {}

// A small file can have a picture drawn over a million times; real ones have about ten scans.
constexpr int kMostScans = 200;

void on_jpeg_progress(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMostScans) return;
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  std::snprintf(errors->message, sizeof errors->message, "it has more than %d scans", kMostScans);
  std::longjmp(errors->back, 1);
}

// Both steps jump back here on errors, over frames of libjpeg only: none of ours that would have to be left in order.
bool read_jpeg_header(jpeg_decompress_struct& jpeg, JpegErrors& errors, std::string_view bytes) {
  if (setjmp(errors.back) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  return true;
}

bool read_jpeg_pixels(jpeg_decompress_struct& jpeg, JpegErrors& errors, std::uint8_t* rgba) {
  if (setjmp(errors.back) != 0) return false;
  jpeg.out_color_space = JCS_EXT_RGBA;
  jpeg.dct_method = JDCT_ISLOW;  // the same bytes on every processor
  jpeg_start_decompress(&jpeg);
  const std::size_t row = std::size_t{4} * jpeg.output_width;
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW at = rgba + row * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

// Frees what libjpeg holds, however reading ends.
struct JpegImage : jpeg_decompress_struct {
  JpegImage() : jpeg_decompress_struct{} {}
  ~JpegImage() { jpeg_destroy_decompress(this); }
  JpegImage(const JpegImage&) = delete;
  JpegImage& operator=(const JpegImage&) = delete;
};

Picture read_jpeg(std::string_view bytes, const std::string& name) {
  JpegErrors errors{};
  JpegImage jpeg;
  jpeg.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = on_jpeg_error;
  errors.base.output_message = on_jpeg_message;
  if (!read_jpeg_header(jpeg, errors, bytes)) fail(name, errors.message);
  check_size(jpeg.image_width, jpeg.image_height, name);
  jpeg_progress_mgr progress{on_jpeg_progress, 0, 0, 0, 0};
  jpeg.progress = &progress;
  Picture picture{static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height), {}};
  picture.rgba.resize(std::size_t{4} * picture.width * picture.height);
  if (!read_jpeg_pixels(jpeg, errors, picture.rgba.data())) fail(name, errors.message);
  return picture;
}

}  // namespace

Picture read_picture(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return read_png(bytes, name);
  if (bytes.starts_with("\xff\xd8\xff")) return read_jpeg(bytes, name);
  throw InvalidInput("picture/format", fmt::format("the picture {} is neither PNG nor JPEG", name), name,
                     "save it as PNG");
}

}  // namespace plico
