// Slits of a sheet with paper on both sides, as two borders each: what knives and outlines need.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

// Every cut that joins two panels becomes two, one a panel: the first keeps its number, the second comes after all
// other edges. Vertices that come apart are doubled; where both ends hold together, the second has one more in its
// middle. Panels keep their numbers, and the place of everything stays. Equal to `sheet` when no cut joins two panels.
// Throws as edge_sides does. O(edges log edges).
CreasePattern open_slits(const CreasePattern& sheet);

}  // namespace plico
