// Panels cut by flat creases, so that a sheet whose whole panels are locked can bend along them.
#pragma once
#include <cstdint>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

struct Facets {
  CreasePattern sheet;     // the edges of the given sheet, then the cuts: flat creases (F) with goal 0
  int first_cut = 0;       // number of edges of the given sheet
  std::vector<int> panel;  // of the given sheet, of each facet
};

// Which diagonals cut a panel: where one opens the way another may lock it, and nobody knows before.
enum class CutChoice {
  Short,  // of least length in all
  Long,   // of least sum of 1 / length
  Drawn   // of least length in all, each length times a random number in [0.1, 4.1)
};

// Every panel cut into triangles by the diagonals of that choice, slivers avoided where they can be, and ears
// whose tip is a vertex with up to three creases: nothing would turn there. No vertex is added. Panels that are not
// simple polygons stay whole. `seed` is for Drawn; panel by panel, of a stream of each. O(corners^3) a panel.
Facets cut_into_facets(const CreasePattern& sheet, CutChoice choice = CutChoice::Short, std::uint64_t seed = 1);

// The sheet with its flat creases (F or J, goal 0) held there: their limit is 0.
CreasePattern with_flat_creases_held(CreasePattern sheet);

}  // namespace plico
