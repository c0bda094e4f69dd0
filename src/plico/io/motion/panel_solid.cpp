#include "plico/io/motion/panel_solid.h"

#include "plico/geom/polygon.h"

namespace plico {

PanelSolid panel_solid(const Linkage& linkage, int panel) {
  const std::vector<Vec3>& outline = linkage.panels[panel];
  const int n = static_cast<int>(outline.size());
  const Vec3 half(0, 0, linkage.thickness / 2);
  const bool thick = linkage.thickness > 0;
  PanelSolid solid;
  std::vector<Vec2> corners;
  for (const Vec3& p : outline) {
    corners.push_back(p.head<2>());
    solid.points.push_back(p + half);
  }
  if (thick)
    for (const Vec3& p : outline) solid.points.push_back(p - half);
  solid.front = triangulate(corners);
  const int below = thick ? n : 0;
  for (const auto& [a, b, c] : solid.front) solid.back.push_back({a + below, c + below, b + below});
  for (int i = 0; thick && i < n; ++i) {
    const int j = (i + 1) % n;
    solid.walls.push_back({i, i + n, j + n});
    solid.walls.push_back({i, j + n, j});
  }
  return solid;
}

}  // namespace plico
