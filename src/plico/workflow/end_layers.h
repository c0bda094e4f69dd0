// Which panel lies on which where a motion ends flat.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/face_order.h"
#include "plico/fold/folding_path.h"

namespace plico {

struct EndLayers {
  bool flat = false;              // every fold of the end is 0 or 180 degrees, and one is 180
  std::vector<FaceOrder> orders;  // of every two panels that lie on each other, judged; empty when there is none
  int places = 0;                 // that the judge looked at
  std::string why;                // flat without orders: a sentence
};

// The sheet whose goal is where the motion ends, folds exact; for verify/flat_layers.h. Its letters follow the folds.
CreasePattern end_of_motion(const CreasePattern& sheet, const Linkage& linkage, const Configuration& end);

// Read off the motion: of two panels that lie on each other at the end, the sides on which they were when they were
// last apart. check_flat_layers then judges the order from the drawing alone. `linkage` is that of `sheet`. Nothing is
// asked of sheets of more than kMostEndLayered panels, whose judge takes long. O(waypoints * pairs).
inline constexpr int kMostEndLayered = 600;
EndLayers end_layers(const CreasePattern& sheet, const Linkage& linkage, const FoldingPath& path);

}  // namespace plico
