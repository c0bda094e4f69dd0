// A thick hinge (Hinge::roll, R11) as what it is mechanically: three plain axes in a row with a narrow strip between
// each two. For whatever knows of one axis a joint only: robot models, animations, pins and holes.
#pragma once
#include "plico/fold/folding_path.h"

namespace plico {

bool has_thick_hinges(const Linkage& linkage);

// The same linkage with plain hinges. Its first panels are the given ones, and move as they do. Hinge h becomes the
// hinges 3h (beyond 90 degrees, in the plane where the fronts will touch), 3h + 1 (the same for the backs) and 3h + 2
// (within 90 degrees, at mid-plane), from the panel at rest outwards; the strips between them are the panels n + 2h and
// n + 2h + 1, as wide as the panels are thick / 2, in the middle of the gap. Hinges that turn about one axis become
// three as well, of which two stay flat. Throws InvalidInput for a linkage with loops. O(panels).
Linkage plain_hinged(const Linkage& linkage);

// Fold angles of the linkage as those of its plain one, which has three times as many.
Configuration plain_angles(const Configuration& config);

// The same motion: a waypoint more wherever a hinge passes +-90 degrees. O(waypoints * hinges), and what is added.
FoldingPath plain_path(const FoldingPath& path);

}  // namespace plico
