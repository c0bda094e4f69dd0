// A page as rows of cells, taken or free, and shapes as rows of cells to be laid on it.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

class Cells {
 public:
  Cells(int width, int height)
      : width_(width),
        height_(height),
        words_((width + 63) / 64),
        bits_(static_cast<std::size_t>(words_) * height, 0) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool at(int x, int y) const { return row(y)[x / 64] >> (x % 64) & 1; }
  void set(int x, int y) { row(y)[x / 64] |= std::uint64_t{1} << (x % 64); }
  void set_row(int y, int x_first, int x_last);

  // Takes every cell of size 1 that the convex polygon touches, also in a point; parts outside are ignored.
  void cover(std::span<const Vec2> convex);

  // All cells within `radius` cells of a taken one, in a field that is larger by ceil(radius) on every side.
  Cells grown(double radius) const;

  // Would `shape`, with its lower left cell at (x, y), hit a taken cell? Parts of it outside are free.
  bool hit_by(const Cells& shape, int x, int y) const;
  void add(const Cells& shape, int x, int y);

 private:
  const std::uint64_t* row(int y) const { return bits_.data() + static_cast<std::size_t>(y) * words_; }
  std::uint64_t* row(int y) { return bits_.data() + static_cast<std::size_t>(y) * words_; }
  // 64 cells of row y from x on; x may be negative or beyond the end.
  std::uint64_t window(int y, int x) const;

  int width_, height_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace plico
