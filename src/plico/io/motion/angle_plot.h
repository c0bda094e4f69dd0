// Fold angles against time as an SVG figure.
#pragma once
#include <string>

#include "plico/fold/folding_path.h"

namespace plico {

struct AnglePlotOptions {
  std::string title = {};       // above the figure; empty for none
  double equal = radians(0.5);  // creases whose angles nowhere differ by more in size share a curve; above 0
  int curves_in_color = 8;      // the largest groups, with a line in the legend each, in [1, 8]; the others are grey
};

// 720 x 420 points: time from flat (0) to folded (1) to the right, the size of the fold angle in degrees upwards. One
// curve for all creases whose angles have the same size; the legend counts its mountains and valleys. Creases that
// never fold are counted but not drawn. Deterministic bytes. O(creases * groups + waypoints * groups).
std::string write_angle_plot(const FoldingPath& path, const AnglePlotOptions& options = {});

}  // namespace plico
