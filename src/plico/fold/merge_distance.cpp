#include "plico/fold/merge_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "plico/geom/box_tree.h"

namespace plico {
namespace {

// All of the drawing's longer side.
constexpr double kRounding = 1e-6;  // what is nearer is rounding of numbers, not of the hand
constexpr double kFarthest = 0.01;  // nobody means ends that far apart to meet

constexpr double kWideGap = 2, kMargin = 1.25;  // ratios
constexpr double kSurely = 1e30;                // the ratio of a gap that holds what is customary
constexpr std::size_t kMostGaps = 5;
constexpr std::int64_t kMostNeighbours = 20'000'000;  // pairs of lines looked at

// Of every line end, how far the nearest end of another line is, and the nearest line that it does not end at.
class EndGaps {
 public:
  EndGaps(const std::vector<DrawnLine>& lines, double size) : lines_(lines), least_(kRounding * size) {
    const double reach = kFarthest * size;
    to_end_.assign(2 * lines.size(), reach);
    to_line_.assign(2 * lines.size(), reach);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const DrawnLine& line : lines) {
      const Vec2 low = line.a.cwiseMin(line.b).array() - reach / 2, high = line.a.cwiseMax(line.b).array() + reach / 2;
      boxes.emplace_back(Vec3(low.x(), low.y(), 0), Vec3(high.x(), high.y(), 0));
    }
    std::int64_t pairs = 0;
    BoxTree(boxes).overlapping_pairs([&](int i, int j) {
      measure(i, j);
      measure(j, i);
      return ++pairs < kMostNeighbours;
    });
  }

  void append_to(std::vector<double>& distances) const {
    distances.insert(distances.end(), to_end_.begin(), to_end_.end());
    distances.insert(distances.end(), to_line_.begin(), to_line_.end());
  }

 private:
  void measure(int i, int j) {
    const std::array<Vec2, 2> ends{lines_[i].a, lines_[i].b};
    const Vec2 &a = lines_[j].a, &b = lines_[j].b;
    const double length = (b - a).squaredNorm();
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec2& p = ends[k];
      const double gap = std::min((p - a).norm(), (p - b).norm());
      double &end = to_end_[2 * static_cast<std::size_t>(i) + k], &line = to_line_[2 * static_cast<std::size_t>(i) + k];
      if (gap > least_) end = std::min(end, gap);
      const double t = length > 0 ? (p - a).dot(b - a) / length : 0;
      if (gap <= least_ || t <= 0 || t >= 1) continue;
      const double beside = (a + t * (b - a) - p).norm();
      if (beside > least_) line = std::min(line, beside);
    }
  }

  const std::vector<DrawnLine>& lines_;
  double least_;
  std::vector<double> to_end_, to_line_;
};

// Half of what all lines but one in twenty are longer than.
double shortest_crease(const std::vector<DrawnLine>& lines, double least) {
  std::vector<double> lengths;
  for (const DrawnLine& line : lines)
    if (const double length = (line.b - line.a).norm(); length > least) lengths.push_back(length);
  if (lengths.empty()) return std::numeric_limits<double>::infinity();
  const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 20);
  std::nth_element(lengths.begin(), at, lengths.end());
  return *at / 2;
}

}  // namespace

std::vector<double> merge_distances(const std::vector<DrawnLine>& lines, double size, double customary) {
  const double least = kRounding * size, most = kFarthest * size, usual = customary * size;
  std::vector<double> distances{least, most};
  EndGaps(lines, size).append_to(distances);
  for (const DrawnLine& line : lines)
    if (const double length = (line.b - line.a).norm(); length > least && length < most) distances.push_back(length);
  std::sort(distances.begin(), distances.end());

  const double limit = std::min(most, shortest_crease(lines, least));
  std::vector<std::pair<double, double>> gaps;  // ratio, middle
  for (std::size_t i = 1; i < distances.size(); ++i) {
    const double low = distances[i - 1], high = distances[i];
    if (low * kMargin <= usual && usual * kMargin <= high && usual <= limit) gaps.emplace_back(kSurely, usual);
    const double middle = std::sqrt(low * high);
    if (high >= kWideGap * low && middle <= limit) gaps.emplace_back(high / low, middle);
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const auto& g, const auto& h) { return g.first > h.first; });
  std::vector<double> found;
  for (std::size_t i = 0; i < gaps.size() && i < kMostGaps; ++i) found.push_back(gaps[i].second);
  for (double more : {usual, 2 * usual, std::min(usual, limit)}) found.push_back(more);
  return found;
}

}  // namespace plico
