#include "plico/stack/peel_level.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

constexpr int kEntry = -1, kBlocked = -2;
constexpr int kCostOfStep = 2;  // and 1 for every hinge that turns
constexpr int kHaste = 2;       // weight of what is left to go

}  // namespace

PeelLevel::PeelLevel(const PeelBodies& bodies, int first, int count, int step, double sample)
    : window_(bodies, first, count),
      step_(step),
      target_(static_cast<int>(std::lround(degrees(bodies.hinge(first).target) / step)) + 180 / step),
      sample_(sample) {
  int all = 1;
  for (int i = 0; i < count; ++i) all *= 3;
  for (int code = 0; code < all; ++code) {
    Cell move{};
    for (int i = 0, rest = code; i < count; ++i, rest /= 3) move[i] = rest % 3 - 1;
    if (move != Cell{}) moves_.push_back(move);
  }
}

int PeelLevel::node_of(const OpenAngles& angles) const {
  int node = 0;
  for (int i = window_.count() - 1; i >= 0; --i)
    node = node * cells() + static_cast<int>(std::lround(degrees(angles[i]) / step_)) + middle();
  return node;
}

PeelLevel::Cell PeelLevel::cell_of(int node) const {
  Cell cell{};
  for (int i = 0; i < window_.count(); ++i, node /= cells()) cell[i] = node % cells();
  return cell;
}

OpenAngles PeelLevel::angles_of(int node) const {
  const Cell cell = cell_of(node);
  OpenAngles angles{};
  // So that -180, -90, 0, 90 and 180 degrees are what the pile and the shape have, to the last bit.
  for (int i = 0; i < window_.count(); ++i) angles[i] = static_cast<double>(cell[i] - middle()) / middle() * kPi;
  return angles;
}

int PeelLevel::moved(int node, const Cell& move) const {
  int offset = 0, unit = 1;
  const Cell at = cell_of(node);
  for (int i = 0; i < window_.count(); ++i, unit *= cells()) {
    const int to = at[i] + move[i];
    if (to < 0 || to >= cells()) return -1;
    offset += move[i] * unit;
  }
  return node + offset;
}

bool PeelLevel::enter(const OpenAngles& angles) {
  const int node = node_of(angles);
  if (from_.contains(node)) return false;
  tries_ = {};
  tries_.push({0, pushed_++, node, kEntry, 0});
  return true;
}

bool PeelLevel::is_reached(const Try& next, PeelEffort& effort) {
  if (next.from == kEntry) return true;
  const OpenAngles angles = angles_of(next.node);
  --effort.nodes;
  if (!window_.free_at(angles)) {
    from_[next.node] = kBlocked;
    return false;
  }
  const OpenAngles from = angles_of(next.from);
  return sample_ > 0 ? window_.free_at_samples(from, angles, sample_)
                     : window_.free_between(from, angles, effort.intervals);
}

void PeelLevel::push_around(int node, int turns) {
  for (const Cell& move : moves_) {
    const int next = moved(node, move);
    if (next < 0 || from_.contains(next)) continue;
    const int cost = turns + kCostOfStep + static_cast<int>(std::ranges::count_if(move, [](int m) { return m != 0; }));
    const int left = std::abs(cell_of(next)[0] - target_) * (kCostOfStep + 1);
    tries_.push({cost + kHaste * left, pushed_++, next, node, cost});
  }
}

std::vector<OpenAngles> PeelLevel::next_way(PeelEffort& effort, const Run& run) {
  while (!tries_.empty() && effort.nodes > 0 && !run.over()) {
    const Try next = tries_.top();
    tries_.pop();
    if (from_.contains(next.node) || !is_reached(next, effort)) continue;
    from_[next.node] = next.from;
    push_around(next.node, next.turns);
    if (cell_of(next.node)[0] == target_) return way_to(next.node);
  }
  return {};
}

// Pieces in one direction are one.
std::vector<OpenAngles> PeelLevel::way_to(int node) const {
  std::vector<int> nodes;
  for (; node != kEntry; node = from_.at(node)) nodes.push_back(node);
  std::ranges::reverse(nodes);
  std::vector<OpenAngles> way{angles_of(nodes.front())};
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (i + 1 == nodes.size() || nodes[i + 1] - nodes[i] != nodes[i] - nodes[i - 1]) way.push_back(angles_of(nodes[i]));
  return way;
}

}  // namespace plico
