#include "plico/stack/rising_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

constexpr long kExchangesPerSquare = 1000, kMostExchanges = 20'000'000;
constexpr int kMostEdges = 8;                       // exchanged at once
constexpr int kPollEvery = 1024;                    // exchanges
constexpr double kWarm = 3, kCooling = 1.0 / 1000;  // places a square of the whole chain; the end, in shares of it

// Twice the voxels' heights, whole numbers.
std::vector<int> heights(const VoxelShell& shell, Upwards upwards) {
  const int axis = static_cast<int>(upwards) % 3, sign = static_cast<int>(upwards) < 3 ? 1 : -1;
  std::vector<int> heights;
  for (const ShellSquare& square : shell.squares) {
    double sum = 0;
    for (const Vec3& corner : corners_of(square)) sum += corner[axis];
    heights.push_back(sign * static_cast<int>(std::lround(sum / 2)));
  }
  return heights;
}

// The places where a square of each height would not be astray.
class WantedPlaces {
 public:
  explicit WantedPlaces(const std::vector<int>& heights) {
    std::vector<int> sorted = heights;
    std::ranges::sort(sorted);
    for (int h : heights) {
      const auto range = std::ranges::equal_range(sorted, h);
      first_.push_back(static_cast<int>(range.begin() - sorted.begin()));
      last_.push_back(static_cast<int>(range.end() - sorted.begin()) - 1);
    }
  }
  int astray(int square, int place) const { return std::max({0, first_[square] - place, place - last_[square]}); }

 private:
  std::vector<int> first_, last_;
};

// By how much an exchange that was just made worsens the walk.
long worse_by(const PathExchange& exchange, const WantedPlaces& wanted) {
  const int first = exchange.first_changed();
  const std::vector<int>& before = exchange.squares_before();
  long sum = 0;
  for (int i = 0; i < static_cast<int>(before.size()); ++i)
    sum += wanted.astray(exchange.path()[first + i], first + i) - wanted.astray(before[i], first + i);
  return sum;
}

void cut_at_lowest(const SquareGraph& graph, const std::vector<int>& heights, std::vector<int>& cycle) {
  if (graph.side_to(cycle.back(), cycle.front()) < 0) return;
  const auto lowest = std::ranges::min_element(cycle, {}, [&](int square) { return heights[square]; });
  std::rotate(cycle.begin(), lowest, cycle.end());
}

}  // namespace

std::array<Upwards, 6> directions_to_rise(const VoxelShell& shell) {
  std::array<std::pair<double, Upwards>, 6> means;  // of heights, as shares of the whole height
  for (int d = 0; d < 6; ++d) {
    const std::vector<int> all = heights(shell, static_cast<Upwards>(d));
    const auto [low, high] = std::ranges::minmax(all);
    double sum = 0;
    for (int h : all) sum += h - low;
    means[d] = {sum / std::max(1, high - low), static_cast<Upwards>(d)};
  }
  std::ranges::sort(means);
  std::array<Upwards, 6> order{};
  for (int d = 0; d < 6; ++d) order[d] = means[d].second;
  return order;
}

double places_astray(const VoxelShell& shell, const std::vector<int>& path, Upwards upwards) {
  const WantedPlaces wanted(heights(shell, upwards));
  double sum = 0;
  for (int p = 0; p < static_cast<int>(path.size()); ++p) sum += wanted.astray(path[p], p);
  return path.empty() ? 0 : sum / static_cast<double>(path.size());
}

std::vector<int> rising_path(const VoxelShell& shell, const SquareGraph& graph, std::vector<int> cycle,
                             const RisingOptions& options, const Run& run) {
  require(options.exchanges >= 0, "exchanges", options.exchanges, "at least 0");
  const std::vector<int> height = heights(shell, options.upwards);
  cut_at_lowest(graph, height, cycle);
  const WantedPlaces wanted(height);
  const int n = graph.size();
  const long tries = options.exchanges > 0 ? options.exchanges : std::min(n * kExchangesPerSquare, kMostExchanges);
  const double cooling = plico::pow(kCooling, kPollEvery / static_cast<double>(tries));
  PathExchange exchange(graph, std::move(cycle));
  Rng rng(options.seed);
  double warmth = kWarm * n;
  for (long i = 0; i < tries; ++i) {
    if (i % kPollEvery == 0) {
      if (run.over()) break;
      warmth *= cooling;
    }
    const int start = rng.below(n);
    if (exchange.exchange(start, 0, kMostEdges, rng) < 0) continue;
    const auto worse = static_cast<double>(worse_by(exchange, wanted));
    if (worse > 0 && rng.uniform() >= plico::pow(2, -worse / warmth)) exchange.undo();
  }
  return exchange.path();
}

}  // namespace plico
