// Convex shells with fewer and fatter triangles, still convex, disjoint and around what they were around.
// Source: [Xi17] 5.4; Sander et al., Silhouette clipping (2000), for the progressive hull.
#pragma once
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/convex/shells.h"

namespace plico {

struct RemeshOptions {
  int faces = 0;             // triangles of a shell are merged until it has no more; 0: none are merged
  int regularize = 0;        // rounds in which every vertex moves so that triangles become fatter; at least 0
  double max_growth = 0.05;  // of each shell's volume, as a share of it; in (0, 1000]
};
void check(const RemeshOptions& options);  // throws InvalidOption

// What became of one shell; volumes are in cubes of the shape's unit.
struct RemeshedShell {
  int triangles_before = 0, triangles = 0;
  double volume_before = 0, volume = 0;
  double fatness_before = 0, fatness = 0;
  int solves = 0;  // small problems solved
};

struct Remeshing {
  Ending ending = Ending::Found;  // Exhausted: some shell kept more triangles than asked for; TimedOut, Stopped
  // The shells with new bodies, contacts for all pairs that came close enough to need a plane, and new polygons.
  // Volumes kept and loss are those before.
  Shells shells;
  std::vector<RemeshedShell> changes;      // one a shell
  double fatness_before = 0, fatness = 0;  // of all triangles together
};

// Laws: every new body is convex and strictly on its side of all planes, exactly; it holds the old one up to 1e-9 of
// the diagonal (by which points on a flat facet may be off); its volume grew by at most max_growth; the result does not
// depend on the number of threads.
//   An edge shrinks to the vertex that adds the least volume: above the triangles around the edge, below those beyond.
//   Cheapest first. A vertex on a facet between shells, or on another flat facet, stays on it.
//   A vertex moves to where the triangles around it are fatter, in as well as out: only the points of the shell as it
//   was hold it back.
// O(n log n) problems of some 20 planes for the first, O(rounds n) of n planes for the second.
Remeshing remesh(const Shells& shells, const RemeshOptions& options = {}, const Run& run = {});

// Area-weighted mean of cos a + cos b + cos c - 1 over the triangles, [Xi17] 5.6.3; 0.5 when all are equilateral.
double fatness(const ConvexPolyhedron& body);

}  // namespace plico
