// Judges an inflated mesh from scratch. Shares no code with what inflates.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

struct InflationVerdict {
  std::vector<std::string> defects;  // one sentence each; of one kind the first
  int hyperbolic_before = 0, hyperbolic = 0;
  double growth = 0;  // of the volume, as a share of it
  bool valid() const { return defects.empty(); }
};

// Checks that `after` has the faces of `before` and is a manifold, that no two faces meet which did not before (exact),
// that no face turned over, that vertices of faces in `keep` and those in `keep_vertices` are where they were, and that
// the volume changed by at most `max_growth`. Never throws for a wrong mesh. O(n log n).
InflationVerdict verify_inflation(const Mesh& before, const PolygonSoup& after, const std::vector<FaceId>& keep,
                                  double max_growth, const std::vector<VertexId>& keep_vertices = {});

}  // namespace plico
