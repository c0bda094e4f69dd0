// Judges how deep a part of a mesh lies below its hull. Shares no code with the cuts (folder segment).
#pragma once
#include "plico/mesh/segmentation.h"

namespace plico {

// A bound for the depth of every vertex below the hull of its part: the largest over all vertices, units; 0 for a part
// that spans no volume. The hull only proposes directions; how far the part reaches in a direction is looked up among
// all its corners, so the bound holds whatever the hull, and is tight when the hull is right.
// O(n h) for h facets of a part's hull.
double concavity_bound(const Mesh& mesh, const Segmentation& parts);

}  // namespace plico
