// What readers of drawings give: a crease pattern, and in words everything that reading changed or assumed.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

constexpr double kLargestCoordinate = 1e15;  // beyond, products of coordinates lose all meaning
constexpr double kRoundedMerge = 1e-5;       // of the sheet: line ends that programs write, and round, meet

struct ImportedPattern {
  CreasePattern sheet;
  std::vector<std::string> notes;  // one sentence each; empty when the file was taken as it stands
};

}  // namespace plico
