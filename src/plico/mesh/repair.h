// Turns a polygon soup into a surface that can be unfolded, and says every change.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

struct RepairOptions {
  double planarity = 1e-5;       // polygons farther off their plane are cut into triangles (check.h); above 0
  double max_coordinate = 1e30;  // faces with a coordinate beyond are removed
};

struct Repaired {
  PolygonSoup soup;               // check_mesh finds no error in it, unless it is empty
  std::vector<std::string> done;  // one sentence a kind of change, in order; empty when nothing was to do
};

// In this order: joins vertices with equal coordinates; removes faces with bad indices or coordinates, without area, or
// given twice; cuts warped and self-crossing polygons into triangles; turns faces to agree with their neighbours, and
// closed components outward; takes the surface apart where an edge has more than two faces, where a one-sided surface
// cannot agree, and at bow-ties; drops vertices without faces. A removed face may leave a hole. Closed components count
// as solids, also when one is a cavity in another. O(n log n).
Repaired repair(const PolygonSoup& soup, const RepairOptions& options = {});

}  // namespace plico
