// Which panels of a flat layout share interior points; exact for the coordinates as written.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/crease_pattern.h"

namespace plico {

struct OverlapOptions {
  // Every panel is first shrunk toward the mean of its corners by this factor, because the rounding of a layout makes
  // panels that touch overlap by some 1e-16. The shrunk coordinates are rounded once; everything after that is exact.
  // A panel with a side that the mean does not see from inside would shrink out of itself; its triangles are shrunk one
  // by one instead, and those thinner than this factor dropped.
  double shrink = 1e-9;
  int max_listed = 1000;        // pairs that are listed, smallest panel numbers first; all are counted
  long max_pairs = 10'000'000;  // stop counting there
};

struct OverlappingPair {
  int a = -1, b = -1;  // panels, a < b
  double area = 0;     // shared, square units, rounded
};

struct Overlaps {
  long count = 0;                       // pairs
  std::vector<OverlappingPair> listed;  // sorted
  OverlappingPair worst;                // of the listed pairs the one that shares the largest area
  bool complete = true;                 // false when the run was over or max_pairs was reached
};

// All pairs of panels that share an interior point; touching is not sharing. Panels may be any simple polygons; a panel
// that is turned over counts like its mirror image, one without area overlaps nothing.
// A sweep along x over boxes that are kept in strips of y: O(n log n) for layouts in which boxes are short against the
// whole, O(n^2) at worst.
Overlaps find_overlaps(const CreasePattern& sheet, const OverlapOptions& options = {}, const Run& run = {});

}  // namespace plico
