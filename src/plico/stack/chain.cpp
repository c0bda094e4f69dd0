#include "plico/stack/chain.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

int side_towards(const ShellSquare& square, int neighbor) {
  const auto found = std::find(square.neighbor.begin(), square.neighbor.end(), neighbor);
  PLICO_ASSERT(found != square.neighbor.end());
  return static_cast<int>(found - square.neighbor.begin());
}

}  // namespace

Chain chain_of(const VoxelShell& shell, const std::vector<int>& cycle, int start, bool backwards) {
  const int n = static_cast<int>(cycle.size());
  Chain chain;
  for (int i = 0; i < n; ++i) chain.squares.push_back(cycle[((backwards ? start - i : start + i) % n + n) % n]);
  Heading heading = Heading::East;
  int entry = -1;  // side of the square at hand by which the chain came in
  for (int i = 0; i + 1 < n; ++i) {
    const ShellSquare& square = shell.squares[chain.squares[i]];
    const int exit = side_towards(square, chain.squares[i + 1]);
    // Straight on is through the opposite side; sides are numbered to the left.
    if (entry >= 0) heading = turned(heading, exit - entry + 2);
    chain.headings.push_back(heading);
    chain.angles.push_back(square.quarter_turn[exit] * kPi / 2);
    entry = square.entry[exit];
  }
  return chain;
}

}  // namespace plico
