// The most compact stack of a surface of squares. Source: [Xi17] 6.3.4; compactness read as R14.
//
// 1. Cuts: the cycle is cut at random places and run both ways over a boustrophedon in its eight symmetries; PileFit
//    tells at once how far each gets.
// 2. Exchanges: the chain is kept up to a little before the pile where it fails, later squares are exchanged at random
//    (PathExchange), and what gets at least as far is kept, until the block is full.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>

#include "plico/base/run.h"
#include "plico/stack/path_exchange.h"
#include "plico/stack/pile_fit.h"

namespace plico {

struct Stack {
  std::vector<int> path;  // squares in the order of the chain
  Headings headings;      // one a hinge
  std::vector<StackFold> folds;
  StackBox box;
};

struct CompactOptions {
  std::uint64_t seed = 1;
  int width = 1, depth = 1;                     // of the base in panels, each at least 1
  int height = 0;                               // layers that are low enough; 0: as few as panels / base allows
  int cuts = 2000;                              // looked at, at least 1
  long exchanges = 10'000'000;                  // tried, at least 0
  int reach = std::numeric_limits<int>::max();  // places by which one exchange moves a square, at most
};

struct CompactResult {
  Ending ending = Ending::Exhausted;  // Found: as low as asked for
  Stack best;
  long exchanges = 0;  // tried; give it as `exchanges` to repeat a timed-out run
};

int ideal_layers(int panels, int width, int depth);

// `cycle` visits every square of `graph` once; with `closed` it may be cut anywhere, if its last square is a neighbour
// of the first. There always is a result: one pile. Throws InvalidOption or InvalidInput.
CompactResult compact_stack(const SquareGraph& graph, const std::vector<int>& cycle, bool closed,
                            const CompactOptions& options = {}, const Run& run = {});

// W + D + H of a stack of panels that are `thickness` thick, in panel sides.
double size_sum(const StackBox& box, double thickness);

// The base with the least W + D + t H for ideal layers, W <= D. The smooth optimum is cbrt(t n).
StackBox best_base(int panels, double thickness);

// The same among those that fit into a block of slots, either way round; empty when there is none.
std::optional<StackBox> best_base_in(const StackBox& room, int panels, double thickness);

}  // namespace plico
