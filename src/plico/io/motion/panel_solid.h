// Triangles of a panel in the flat state, for everything that draws: a sheet's two sides, or a plate around z = 0.
#pragma once
#include <array>
#include <vector>

#include "plico/fold/linkage.h"

namespace plico {

struct PanelSolid {
  std::vector<Vec3> points;  // the outline on the front; the outline on the back follows when the panel is thick
  std::vector<std::array<int, 3>> front, back, walls;  // counter-clockwise seen from outside; a sheet has no walls
};
PanelSolid panel_solid(const Linkage& linkage, int panel);

}  // namespace plico
