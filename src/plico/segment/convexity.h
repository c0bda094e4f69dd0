// Parts that are nearly convex, cut along edges of the mesh: no vertex lies deep below the hull of its part.
// After convex ridge separation (Liu, Xi and Lien 2016; [Xi17] 4.4.2), whose details and code are not public.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/mesh.h"

namespace plico {

struct ConvexityOptions {
  double concavity = 0.05;  // depth of a vertex below the hull of its part, as a share of the mesh's diagonal; above 0
};
void check(const ConvexityOptions& options);  // throws InvalidOption naming field, value and range

// The part of each face, 0..k-1; parts are connected, and no vertex lies deeper below the hull of its part than the
// bound (segment/hull_depth.h).
//   1. The vertices of a part, added by growing depth below its hull, join to ridges: what hangs together and reaches
//      the hull. The depth at which two ridges join is the least that stays as long as they are in one part. The two
//      that join deepest are parted by a minimum cut, cheap in valleys and deep down; both sides again.
//   2. Neighbours are joined as long as their common part obeys the bound.
//   3. Seams are made shorter, each by minimum cuts of the two parts it lies between, as the bound allows.
// Small meshes (up to kSmallMesh faces) are cut with several weights and joined in several orders; the best is the one
// with the least length of seams in diagonals plus kPricePerPart for each part.
// O(n log n + n h) a level of cuts, for hulls of h facets. A run that is over leaves more parts than needed, all of
// them in the bound; otherwise the result does not depend on the number of threads.
std::vector<int> cut_by_convexity(const Mesh& mesh, const ConvexityOptions& options = {}, const Run& run = {});

inline constexpr int kSmallMesh = 1000;
inline constexpr double kPricePerPart = 0.25;  // diagonals: a kit of one part less may have so much more seam

}  // namespace plico
