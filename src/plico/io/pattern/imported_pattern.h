// What readers of drawings give: a crease pattern, and in words everything that reading changed or assumed.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

constexpr double kLargestCoordinate = 1e15;  // beyond, products of coordinates lose all meaning
constexpr double kDrawnMerge = 1e-3;         // of the drawing: where drawings by hand say nothing better
constexpr double kFlatness = 2.5e-3;         // of the drawing: a circle as wide as it becomes 36 lines
constexpr double kLeastFlatness = 1e-5;      // of the drawing; less would only make millions of creases
constexpr double kRoundedMerge = 1e-5;       // of the sheet: line ends that programs write, and round, meet

// How drawings become creases. Lengths in the drawing's unit; 0: found from the drawing.
struct DrawingOptions {
  double merge = 0;    // line ends closer than this are joined
  double flatten = 0;  // how far the straight lines that replace a curve may be from it
};
void check(const DrawingOptions& options);  // throws InvalidOption

struct ImportedPattern {
  CreasePattern sheet;
  std::vector<std::string> notes;  // one sentence each; empty when the file was taken as it stands
};

}  // namespace plico
