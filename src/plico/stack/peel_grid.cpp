#include "plico/stack/peel_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <utility>

namespace plico {
namespace {

constexpr int kCells = 25, kMiddle = 12;  // -180, -165, ... 180 degrees, and 0 among them
constexpr int kMostWays = 200;

using Cell = std::array<int, 3>;

class GridSearch {
 public:
  GridSearch(const PeelWindow& window, long& nodes, long& intervals, const Run& run)
      : window_(window),
        nodes_(nodes),
        intervals_(intervals),
        run_(run),
        start_(number(cell_of(window.start()))),
        end_(number(cell_of(window.end()))),
        free_(size(), -1) {
    free_[start_] = free_[end_] = 1;
    for (int code = 0; code < power(3); ++code) {
      Cell move{};
      for (int i = 0, rest = code; i < window.count(); ++i, rest /= 3) move[i] = rest % 3 - 1;
      if (move != Cell{}) moves_.push_back(move);
    }
  }

  std::vector<Angles3> run() {
    for (int way = 0; way < kMostWays; ++way) {
      const std::vector<int> cells = shortest();
      if (cells.empty()) return {};
      if (proven(cells)) return joined(cells);
    }
    return {};
  }

 private:
  int power(int base) const {
    int result = 1;
    for (int i = 0; i < window_.count(); ++i) result *= base;
    return result;
  }
  int size() const { return power(kCells); }
  Cell cell_of(const Angles3& angles) const {
    Cell cell{};
    for (int i = 0; i < window_.count(); ++i)
      cell[i] = static_cast<int>(std::lround(angles[i] / radians(15))) + kMiddle;
    return cell;
  }
  int number(const Cell& cell) const { return cell[0] + kCells * (cell[1] + kCells * cell[2]); }
  Cell cell(int number) const { return {number % kCells, number / kCells % kCells, number / (kCells * kCells)}; }
  Angles3 angles(int number) const {
    const Cell at = cell(number);
    Angles3 result{};
    for (int i = 0; i < window_.count(); ++i) result[i] = radians(15.0 * (at[i] - kMiddle));
    if (number == start_) return window_.start();
    if (number == end_) return window_.end();
    return result;
  }

  bool is_free(int node) {
    if (free_[node] < 0) {
      --nodes_;
      free_[node] = window_.free_at(angles(node)) ? 1 : 0;
    }
    return free_[node] == 1;
  }

  // Longest turn of any angle still to go, in cells.
  int left(int node) const {
    const Cell a = cell(node), b = cell(end_);
    int most = 0;
    for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  std::vector<int> shortest() {
    std::vector<int> steps(size(), std::numeric_limits<int>::max()), from(size(), -1);
    std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>> open;
    steps[start_] = 0;
    open.emplace(left(start_), start_);
    while (!open.empty()) {
      const auto [estimate, node] = open.top();
      open.pop();
      if (node == end_) return back_from(from);
      if (estimate > steps[node] + left(node)) continue;
      if (nodes_ <= 0 || run_.over()) return {};
      for (const Cell& move : moves_) {
        const int next = moved(node, move);
        if (next < 0 || steps[next] <= steps[node] + 1 || barred_.contains({node, next}) || !is_free(next)) continue;
        steps[next] = steps[node] + 1;
        from[next] = node;
        open.emplace(steps[next] + left(next), next);
      }
    }
    return {};
  }

  int moved(int node, const Cell& move) const {
    Cell at = cell(node);
    for (int i = 0; i < window_.count(); ++i) {
      at[i] += move[i];
      if (at[i] < 0 || at[i] >= kCells) return -1;
    }
    return number(at);
  }

  std::vector<int> back_from(const std::vector<int>& from) const {
    std::vector<int> cells;
    for (int node = end_; node >= 0; node = from[node]) cells.push_back(node);
    std::ranges::reverse(cells);
    return cells;
  }

  bool proven(const std::vector<int>& cells) {
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      const std::pair<int, int> piece{cells[i], cells[i + 1]};
      if (proven_.contains(piece)) continue;
      if (!window_.free_between(angles(piece.first), angles(piece.second), intervals_)) {
        barred_.insert(piece);
        barred_.insert({piece.second, piece.first});
        return false;
      }
      proven_.insert(piece);
    }
    return true;
  }

  // Pieces in one direction are one.
  std::vector<Angles3> joined(const std::vector<int>& cells) const {
    const auto step = [&](std::size_t i) {
      const Cell a = cell(cells[i]), b = cell(cells[i + 1]);
      return Cell{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    };
    std::vector<Angles3> way{angles(cells[0])};
    for (std::size_t i = 1; i < cells.size(); ++i)
      if (i + 1 == cells.size() || step(i) != step(i - 1)) way.push_back(angles(cells[i]));
    return way;
  }

  const PeelWindow& window_;
  long &nodes_, &intervals_;
  const Run& run_;
  int start_, end_;
  std::vector<signed char> free_;  // of each cell: 1 yes, 0 no, -1 not looked at
  std::vector<Cell> moves_;
  std::set<std::pair<int, int>> barred_, proven_;
};

}  // namespace

std::vector<Angles3> find_on_grid(const PeelWindow& window, long& nodes, long& intervals, const Run& run) {
  return GridSearch(window, nodes, intervals, run).run();
}

}  // namespace plico
