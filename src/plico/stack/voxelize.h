// From a surface to the voxels that it touches and encloses. Source: [Xi17] 6.3.1.
#pragma once
#include "plico/mesh/soup.h"
#include "plico/stack/voxel_shell.h"

namespace plico {

struct Voxelization {
  VoxelGrid grid;                // what the surface touches, and what that encloses
  double side = 1;               // of a voxel, the mesh's unit
  Vec3 origin = Vec3::Zero();    // where voxel (0, 0, 0) begins
  long touched = 0, filled = 0;  // solid voxels: on the surface, and in all
};

// `cells` voxels along the longest side of the surface's bounding box, not necessarily a whole number; the box lies in
// the middle of the grid. A voxel counts when some triangle of a polygon touches it, its border included (separating
// axes, in rounded arithmetic: ties may go either way, but always the same). Any polygons will do: open, crossing, in
// several pieces. Throws InvalidOption unless cells is at least 1 and the grid fits (VoxelGrid::kMostVoxels),
// InvalidInput when there is no polygon or no extent. O(voxels touched * log cells + voxels).
Voxelization voxelize(const PolygonSoup& soup, double cells);

// The number of cells whose shell has `squares` squares, or comes closest of those that were tried: about forty
// bisections. Throws as voxelize(), and InvalidOption when squares is below 6.
double cells_for_squares(const PolygonSoup& soup, int squares);

}  // namespace plico
