#include "plico/fabricate/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plico {

void Cells::set_row(int y, int x_first, int x_last) {
  if (y < 0 || y >= height_) return;
  for (int x = std::max(0, x_first); x <= std::min(width_ - 1, x_last); ++x) set(x, y);
}

void Cells::cover(std::span<const Vec2> convex) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2& p : convex) low = std::min(low, p.y()), high = std::max(high, p.y());
  constexpr double kTouch = 1e-9;  // rounding must not let a touched cell go free
  for (int y = std::max(0, static_cast<int>(std::floor(low - kTouch)));
       y <= std::min<double>(height_ - 1, std::floor(high + kTouch)); ++y) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t i = 0; i < convex.size(); ++i) {  // the part of each side in the band [y, y + 1]
      Vec2 a = convex[i], b = convex[(i + 1) % convex.size()];
      if (a.y() > b.y()) std::swap(a, b);
      if (b.y() < y - kTouch || a.y() > y + 1 + kTouch) continue;
      const double rise = b.y() - a.y();
      const auto x_at = [&](double level) {
        return rise <= 0 ? a.x() : a.x() + (b.x() - a.x()) * std::clamp((level - a.y()) / rise, 0.0, 1.0);
      };
      for (double x : {x_at(y), x_at(y + 1.0)}) left = std::min(left, x), right = std::max(right, x);
      if (rise <= 0) left = std::min(left, b.x()), right = std::max(right, b.x());
    }
    if (left <= right)
      set_row(y, static_cast<int>(std::floor(left - kTouch)), static_cast<int>(std::floor(right + kTouch)));
  }
}

Cells Cells::grown(double radius) const {
  const int r = static_cast<int>(std::ceil(radius));
  Cells result(width_ + 2 * r, height_ + 2 * r);
  for (int dy = -r; dy <= r; ++dy) {
    const double across = radius * radius - dy * dy;
    if (across < 0) continue;
    const int dx = static_cast<int>(std::sqrt(across));
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_;) {  // runs of taken cells
        if (!at(x, y)) {
          ++x;
          continue;
        }
        int end = x;
        while (end + 1 < width_ && at(end + 1, y)) ++end;
        result.set_row(y + dy + r, x + r - dx, end + r + dx);
        x = end + 1;
      }
    }
  }
  return result;
}

std::uint64_t Cells::window(int y, int x) const {
  const int word = x >= 0 ? x / 64 : -((63 - x) / 64), shift = x - 64 * word;
  const auto get = [&](int w) { return w >= 0 && w < words_ ? row(y)[w] : 0; };
  return shift == 0 ? get(word) : get(word) >> shift | get(word + 1) << (64 - shift);
}

bool Cells::hit_by(const Cells& shape, int x, int y) const {
  for (int j = std::max(0, -y); j < shape.height_ && y + j < height_; ++j)
    for (int w = 0; w < shape.words_; ++w)
      if (const std::uint64_t bits = shape.row(j)[w]; bits && (bits & window(y + j, x + 64 * w))) return true;
  return false;
}

void Cells::add(const Cells& shape, int x, int y) {
  for (int j = 0; j < shape.height_; ++j)
    for (int i = 0; i < shape.width_; ++i)
      if (shape.at(i, j)) set_row(y + j, x + i, x + i);
}

}  // namespace plico
