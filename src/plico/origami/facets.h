// Panels cut by flat creases, so that a sheet whose whole panels are locked can bend along them.
#pragma once
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

struct Facets {
  CreasePattern sheet;     // the edges of the given sheet, then the cuts: flat creases (F) with goal 0
  int first_cut = 0;       // number of edges of the given sheet
  std::vector<int> panel;  // of the given sheet, of each facet
};

// Every panel cut into triangles by the diagonals of least length in all, slivers avoided where they can be, and ears
// whose tip is a vertex with up to three creases: nothing would turn there. No vertex is added. Panels that are not
// simple polygons stay whole. O(corners^3) a panel.
Facets cut_into_facets(const CreasePattern& sheet);

// The sheet with its flat creases (F or J, goal 0) held there: their limit is 0.
CreasePattern with_flat_creases_held(CreasePattern sheet);

}  // namespace plico
