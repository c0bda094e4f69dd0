#include "plico/io/motion/gif.h"

#include <algorithm>
#include <array>

#include "plico/base/error.h"
#include "plico/io/text/bytes.h"

namespace plico {
namespace {

constexpr int kColours = 256, kGifBits = 6, kBins = 1 << 3 * kGifBits;

using GifColour = std::array<int, 3>;

// On white, by how opaque it is.
GifColour colour_at(const Picture& picture, std::size_t pixel) {
  const std::uint8_t* at = picture.rgba.data() + 4 * pixel;
  GifColour result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = (at[k] * at[3] + 255 * (255 - at[3]) + 127) / 255;
  return result;
}

// The first bits of each channel.
int bin_of(const GifColour& colour) {
  int bin = 0;
  for (const int channel : colour) bin = bin << kGifBits | channel >> (8 - kGifBits);
  return bin;
}

// Pixels in one bin: how many, and their sum.
struct Bin {
  int bin = 0;
  long count = 0;
  std::array<long, 3> sum{};
  int channel(int k) const { return bin >> kGifBits * (2 - k) & ((1 << kGifBits) - 1); }
};

struct Palette {
  std::vector<GifColour> colours;
  std::vector<std::uint8_t> of_bin = std::vector<std::uint8_t>(kBins, 0);
};

std::vector<Bin> used_bins(const std::vector<Picture>& pictures) {
  std::vector<Bin> all(kBins);
  for (const Picture& picture : pictures)
    for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i) {
      const GifColour colour = colour_at(picture, i);
      Bin& bin = all[static_cast<std::size_t>(bin_of(colour))];
      ++bin.count;
      for (std::size_t k = 0; k < 3; ++k) bin.sum[k] += colour[k];
    }
  for (int b = 0; b < kBins; ++b) all[static_cast<std::size_t>(b)].bin = b;
  std::erase_if(all, [](const Bin& bin) { return bin.count == 0; });
  return all;
}

// A box of the median cut: bins [first, last), and how wide it is where it is widest.
struct ColourBox {
  std::size_t first = 0, last = 0;
  int axis = 0, width = 0;
};

ColourBox box_of_bins(const std::vector<Bin>& bins, std::size_t first, std::size_t last) {
  ColourBox box{first, last, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(
        bins.begin() + static_cast<std::ptrdiff_t>(first), bins.begin() + static_cast<std::ptrdiff_t>(last),
        [k](const Bin& a, const Bin& b) { return a.channel(k) < b.channel(k); });
    const int width = high->channel(k) - low->channel(k);
    if (width > box.width) box.axis = k, box.width = width;
  }
  return box;
}

// Half of the bins to each side: small areas keep colours of their own.
std::size_t sort_and_halve(std::vector<Bin>& bins, const ColourBox& box) {
  std::sort(bins.begin() + static_cast<std::ptrdiff_t>(box.first), bins.begin() + static_cast<std::ptrdiff_t>(box.last),
            [&](const Bin& a, const Bin& b) {
              return std::pair(a.channel(box.axis), a.bin) < std::pair(b.channel(box.axis), b.bin);
            });
  return box.first + (box.last - box.first) / 2;
}

Palette median_cut(const std::vector<Picture>& pictures) {
  std::vector<Bin> bins = used_bins(pictures);
  std::vector<ColourBox> boxes{box_of_bins(bins, 0, bins.size())};
  while (boxes.size() < kColours) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(), [](const ColourBox& a, const ColourBox& b) {
      return std::pair(a.width, a.last - a.first) < std::pair(b.width, b.last - b.first);
    });
    if (widest->width == 0) break;
    const std::size_t middle = sort_and_halve(bins, *widest), first = widest->first, last = widest->last;
    *widest = box_of_bins(bins, first, middle);
    boxes.push_back(box_of_bins(bins, middle, last));
  }
  Palette palette;
  for (const ColourBox& box : boxes) {
    Bin all;
    for (std::size_t i = box.first; i < box.last; ++i) {
      all.count += bins[i].count;
      for (std::size_t k = 0; k < 3; ++k) all.sum[k] += bins[i].sum[k];
      palette.of_bin[static_cast<std::size_t>(bins[i].bin)] = static_cast<std::uint8_t>(palette.colours.size());
    }
    GifColour& mean = palette.colours.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<int>((all.sum[k] + all.count / 2) / all.count);
  }
  palette.colours.resize(kColours);
  return palette;
}

std::vector<std::uint8_t> numbers_of(const Picture& picture, const Palette& palette) {
  std::vector<std::uint8_t> numbers(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = palette.of_bin[static_cast<std::size_t>(bin_of(colour_at(picture, i)))];
  return numbers;
}

// Variable-length codes of LZW, in blocks of at most 255 bytes.
class LzwWriter {
 public:
  explicit LzwWriter(std::string& out) : out_(out) {}

  void write(const std::vector<std::uint8_t>& numbers) {
    out_ += static_cast<char>(8);  // bits of a number
    restart();
    int prefix = -1;
    for (const std::uint8_t number : numbers) prefix = prefix < 0 ? number : take(prefix, number);
    put(prefix);
    put(kEnd);
    if (held_ > 0) block_ += static_cast<char>(bits_ & 0xff);
    flush();
    out_ += '\0';
  }

 private:
  static constexpr int kClear = 256, kEnd = 257, kFirst = 258, kLast = 4095;

  // The code of the longest known row of numbers that ends in `number`.
  int take(int prefix, std::uint8_t number) {
    std::int16_t& known = next_[static_cast<std::size_t>(prefix) * 256 + number];
    if (known >= 0) return known;
    put(prefix);
    if (code_ > kLast) {
      restart();
      return number;
    }
    if (code_ == 1 << width_) ++width_;
    known = static_cast<std::int16_t>(code_++);
    return number;
  }

  void restart() {
    if (!next_.empty()) put(kClear);
    next_.assign(std::size_t{4096} * 256, -1);
    code_ = kFirst;
    if (width_ == 0) width_ = 9, put(kClear);
    width_ = 9;
  }

  void put(int code) {
    bits_ |= static_cast<std::uint32_t>(code) << held_;
    held_ += width_;
    for (; held_ >= 8; held_ -= 8, bits_ >>= 8) {
      block_ += static_cast<char>(bits_ & 0xff);
      if (block_.size() == 255) flush();
    }
  }

  void flush() {
    if (block_.empty()) return;
    out_ += static_cast<char>(block_.size());
    out_ += block_;
    block_.clear();
  }

  std::string& out_;
  std::string block_;
  std::vector<std::int16_t> next_;  // of a code and a number: the code of both
  std::uint32_t bits_ = 0;
  int held_ = 0, width_ = 0, code_ = kFirst;
};

struct Rectangle {
  int x = 0, y = 0, width = 1, height = 1;  // a picture like the one before still is one
};

Rectangle where_they_differ(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int width) {
  int left = width, right = -1, top = -1, bottom = -1;
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    if (a[static_cast<std::size_t>(i)] == b[static_cast<std::size_t>(i)]) continue;
    const int x = i % width, y = i / width;
    left = std::min(left, x), right = std::max(right, x);
    if (top < 0) top = y;
    bottom = y;
  }
  return right < 0 ? Rectangle{} : Rectangle{left, top, right - left + 1, bottom - top + 1};
}

void append_short(std::string& out, int number) { append_number(out, static_cast<std::uint16_t>(number)); }

void append_head(std::string& out, const Picture& size, const Palette& palette) {
  out += "GIF89a";
  append_short(out, size.width);
  append_short(out, size.height);
  out += std::string("\xf7\0\0", 3);  // a palette of 256 colours for all pictures
  for (const GifColour& colour : palette.colours)
    for (const int channel : colour) out += static_cast<char>(channel);
  out += std::string("!\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19);  // for ever
}

void append_picture(std::string& out, const std::vector<std::uint8_t>& numbers, int width, const Rectangle& part,
                    int delay) {
  out += std::string("!\xf9\x04\x04", 4);  // what was there before stays
  append_short(out, delay);
  out += std::string("\0\0,", 3);
  for (const int number : {part.x, part.y, part.width, part.height}) append_short(out, number);
  out += '\0';
  std::vector<std::uint8_t> inside;
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto row = numbers.begin() + std::ptrdiff_t(y) * width + part.x;
    inside.insert(inside.end(), row, row + part.width);
  }
  LzwWriter(out).write(inside);
}

}  // namespace

std::string write_gif(const std::vector<Picture>& pictures, const GifOptions& options) {
  PLICO_ASSERT(!pictures.empty());
  const Picture& first = pictures.front();
  const Palette palette = median_cut(pictures);
  std::string out;
  append_head(out, first, palette);
  std::vector<std::uint8_t> shown;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    PLICO_ASSERT(pictures[i].width == first.width && pictures[i].height == first.height);
    std::vector<std::uint8_t> numbers = numbers_of(pictures[i], palette);
    const Rectangle part =
        i == 0 ? Rectangle{0, 0, first.width, first.height} : where_they_differ(shown, numbers, first.width);
    append_picture(out, numbers, first.width, part, i + 1 == pictures.size() ? options.last_delay : options.delay);
    shown = std::move(numbers);
  }
  out += ';';
  return out;
}

}  // namespace plico
