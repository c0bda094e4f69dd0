#include "plico/verify/shell_cycle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

namespace plico {
namespace {

constexpr std::size_t kMostProblems = 10;

using Point = std::array<int, 3>;  // twice the grid coordinates, so that middles are whole
using Square = std::pair<Voxel, int>;

Point normal_of(int axis) {
  Point n{0, 0, 0};
  n[axis / 2] = axis % 2 ? -1 : 1;
  return n;
}

// The middles of the four edges of a square.
std::array<Point, 4> edges_of(const Square& square) {
  const auto& [v, axis] = square;
  const Point n = normal_of(axis);
  const Point centre{2 * v.x + 1 + n[0], 2 * v.y + 1 + n[1], 2 * v.z + 1 + n[2]};
  std::array<Point, 4> edges;
  int count = 0;
  for (int i = 0; i < 3; ++i)
    for (int sign : {-1, 1})
      if (i != axis / 2) {
        edges[count] = centre;
        edges[count++][i] += sign;
      }
  return edges;
}

Voxel in_front(const Square& square) {
  const Point n = normal_of(square.second);
  return {square.first.x + n[0], square.first.y + n[1], square.first.z + n[2]};
}

std::set<Square> boundary_of(const VoxelGrid& grid) {
  std::set<Square> boundary;
  for (int z = 0; z < grid.nz(); ++z)
    for (int y = 0; y < grid.ny(); ++y)
      for (int x = 0; x < grid.nx(); ++x)
        for (int axis = 0; axis < 6 && grid.solid({x, y, z}); ++axis)
          if (const Square square{{x, y, z}, axis}; !grid.solid(in_front(square))) boundary.insert(square);
  return boundary;
}

std::string text(const Square& s) {
  return fmt::format("square {} {} {} {}{}", s.first.x, s.first.y, s.first.z, s.second % 2 ? '-' : '+',
                     "xyz"[s.second / 2]);
}

class CycleJudge {
 public:
  CycleJudge(const VoxelGrid& grid, Pairing pairing) : pairing_(pairing), boundary_(boundary_of(grid)) {
    for (const Square& square : boundary_)
      for (const Point& edge : edges_of(square)) ++at_edge_[edge];
    verdict_.squares = static_cast<int>(boundary_.size());
  }

  CycleVerdict judge(const std::vector<ShellSquare>& walk, bool closed) {
    std::set<Square> seen;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const ShellSquare& next = walk[(i + 1) % walk.size()];
      const Square a{walk[i].voxel, static_cast<int>(walk[i].normal)}, b{next.voxel, static_cast<int>(next.normal)};
      if (!boundary_.count(a)) tell(fmt::format("{} is no part of the boundary", text(a)));
      if (!seen.insert(a).second) tell(fmt::format("{} is visited twice", text(a)));
      if ((closed || i + 1 < walk.size()) && !are_joined(a, b))
        tell(fmt::format("{} and {} follow each other and are not joined", text(a), text(b)));
    }
    if (seen.size() < boundary_.size())
      tell(fmt::format("{} of {} squares are visited", seen.size(), boundary_.size()));
    return std::move(verdict_);
  }

 private:
  bool are_joined(const Square& a, const Square& b) const {
    for (const Point& edge : edges_of(a))
      for (const Point& other : edges_of(b))
        if (a != b && edge == other && is_paired(a, b, edge)) return true;
    return false;
  }

  bool is_paired(const Square& a, const Square& b, const Point& edge) const {
    const auto meeting = at_edge_.find(edge);
    if (meeting == at_edge_.end() || meeting->second != 4) return true;
    return pairing_ == Pairing::Solid ? a.first == b.first : in_front(a) == in_front(b);
  }

  void tell(std::string problem) {
    if (verdict_.problems.size() < kMostProblems) verdict_.problems.push_back(std::move(problem));
  }

  Pairing pairing_;
  std::set<Square> boundary_;
  std::map<Point, int> at_edge_;  // how many squares meet there
  CycleVerdict verdict_;
};

}  // namespace

CycleVerdict verify_shell_cycle(const VoxelGrid& grid, Pairing pairing, const std::vector<ShellSquare>& cycle) {
  return CycleJudge(grid, pairing).judge(cycle, true);
}

CycleVerdict verify_shell_path(const VoxelGrid& grid, Pairing pairing, const std::vector<ShellSquare>& path) {
  return CycleJudge(grid, pairing).judge(path, false);
}

}  // namespace plico
