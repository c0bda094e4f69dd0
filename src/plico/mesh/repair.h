// Turns a polygon soup into a surface that can be unfolded, and says every change.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

// How far a repair may go. Safe does what has one remedy and changes no shape: corners are joined when that closes the
// surface, polygons that are not flat are cut into triangles, faces without area and duplicates go, faces are turned to
// agree, bow-ties are split. Full also drops what cannot be used and takes apart edges with more than two faces.
enum class RepairLevel { Safe, Full };

struct RepairOptions {
  RepairLevel level = RepairLevel::Full;
  double planarity = 1e-5;                 // polygons farther off their plane are cut into triangles (check.h); above 0
  double max_coordinate = kMaxCoordinate;  // faces with a coordinate beyond are removed
  // Faces with less area, as part of the square of their size, have none: thinner than single precision can say, they
  // are left over where a vertex was meant to lie on an edge. At least 0.
  double least_area = 1.2e-7;
};

// What folds exactly is flat to rounding: a net of polygons farther off their planes does not close to 1e-9.
constexpr double kFlatPolygon = 1e-11;

struct Repaired {
  PolygonSoup soup;               // Full: check_mesh finds no error in it, unless it is empty
  std::vector<std::string> done;  // one sentence a kind of change, in order; empty when nothing was to do
};

// Full, in this order: joins vertices with equal coordinates; removes faces with bad indices or coordinates, without
// area, or given twice; cuts warped and self-crossing polygons into triangles; turns faces to agree with their
// neighbours, and closed components outward; takes the surface apart where an edge has more than two faces, where a
// one-sided surface cannot agree, and at bow-ties; drops vertices without faces. A removed face may leave a hole.
// Closed components count as solids, also when one is a cavity in another. Safe leaves out what RepairLevel says;
// errors may remain. O(n log n).
Repaired repair(const PolygonSoup& soup, const RepairOptions& options = {});

}  // namespace plico
