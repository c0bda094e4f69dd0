#include "plico/io/motion/gif.h"

#include <gmock/gmock.h>

#include "plico/base/rng.h"

namespace plico {
namespace {

Picture plain(int width, int height, int red, int green, int blue) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const int channel : {red, green, blue, 255}) picture.rgba.push_back(static_cast<std::uint8_t>(channel));
  return picture;
}

// A reader of what write_gif() writes, independent of it: the pictures as they are shown.
class GifReader {
 public:
  explicit GifReader(const std::string& bytes) : bytes_(bytes) {}

  std::vector<Picture> read() {
    EXPECT_EQ(bytes_.substr(0, 6), "GIF89a");
    at_ = 6;
    const int width = number(), height = number();
    shown_ = plain(width, height, 1, 2, 3);
    at_ += 3;
    palette_ = bytes_.substr(at_, 768);
    at_ += 768;
    std::vector<Picture> pictures;
    for (int mark = byte(); mark != ';'; mark = byte()) {
      if (mark == '!') {
        byte();
        blocks();
      } else {
        EXPECT_EQ(mark, ',');
        read_picture();
        pictures.push_back(shown_);
      }
    }
    EXPECT_EQ(at_, bytes_.size());
    return pictures;
  }

 private:
  int byte() { return static_cast<unsigned char>(bytes_.at(at_++)); }
  int number() {
    const int low = byte();
    return low + 256 * byte();
  }
  std::string blocks() {
    std::string all;
    for (int size = byte(); size > 0; size = byte()) {
      all += bytes_.substr(at_, static_cast<std::size_t>(size));
      at_ += static_cast<std::size_t>(size);
    }
    return all;
  }

  void read_picture() {
    const int x = number(), y = number(), width = number(), height = number();
    EXPECT_EQ(byte(), 0);
    EXPECT_EQ(byte(), 8);
    const std::string pixels = decoded(blocks());
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int i = 0; i < width * height; ++i)
      for (int k = 0; k < 3; ++k)
        shown_.rgba[static_cast<std::size_t>(4 * ((y + i / width) * shown_.width + x + i % width) + k)] =
            static_cast<std::uint8_t>(palette_[static_cast<std::size_t>(
                3 * static_cast<unsigned char>(pixels[static_cast<std::size_t>(i)]) + k)]);
  }

  static std::string decoded(const std::string& codes) {
    std::vector<std::string> table;
    std::string result, previous;
    std::size_t bit = 0;
    const auto clear = [&] {
      table.clear();
      for (int i = 0; i < 258; ++i) table.push_back(std::string(1, static_cast<char>(i)));
      previous.clear();
    };
    clear();
    for (std::size_t width = 9;;) {
      std::size_t code = 0;
      for (std::size_t i = 0; i < width; ++i, ++bit)
        code |= static_cast<std::size_t>(codes.at(bit / 8) >> (bit % 8) & 1) << i;
      if (code == 257) return result;
      if (code == 256) {
        clear();
        width = 9;
        continue;
      }
      const std::string row = code < table.size() ? table[code] : previous + previous[0];
      if (!previous.empty() && table.size() < 4096) table.push_back(previous + row[0]);
      result += row;
      previous = row;
      if (table.size() == std::size_t{1} << width && width < 12) ++width;
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  std::string palette_;
  Picture shown_;
};

TEST(WriteGif, PicturesOfFewColoursReadBackAsTheyWere) {
  std::vector<Picture> pictures{plain(40, 30, 250, 10, 10), plain(40, 30, 250, 10, 10)};
  for (int x = 5; x < 9; ++x)
    for (int y = 20; y < 28; ++y) pictures[1].rgba[static_cast<std::size_t>(4 * (40 * y + x) + 2)] = 200;
  pictures.push_back(pictures[1]);  // nothing changes
  const std::string bytes = write_gif(pictures);
  const std::vector<Picture> read = GifReader(bytes).read();
  ASSERT_EQ(read.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read[i].rgba, pictures[i].rgba) << i;
}

TEST(WriteGif, PicturesOfAllColoursComeClose) {
  Rng rng(1);
  Picture noise = plain(120, 100, 0, 0, 0);
  for (std::size_t i = 0; i < noise.rgba.size(); ++i)
    if (i % 4 < 3) noise.rgba[i] = static_cast<std::uint8_t>(rng.below(256));
  const std::string bytes = write_gif({noise});  // so long that its codes begin anew
  const std::vector<Picture> read = GifReader(bytes).read();
  ASSERT_EQ(read.size(), 1U);
  double off = 0;
  for (std::size_t i = 0; i < noise.rgba.size(); ++i) off += std::abs(int{read[0].rgba[i]} - int{noise.rgba[i]});
  EXPECT_LT(off / double(noise.rgba.size()), 12);  // 256 colours, so about 6 levels a channel: 256 / 6 / 4 at most
}

TEST(WriteGif, WhatIsTransparentIsWhite) {
  Picture clear = plain(4, 4, 0, 0, 0);
  for (std::size_t i = 3; i < clear.rgba.size(); i += 4) clear.rgba[i] = 0;
  const std::string bytes = write_gif({clear});
  EXPECT_EQ(GifReader(bytes).read().front().rgba[0], 255);
}

}  // namespace
}  // namespace plico
