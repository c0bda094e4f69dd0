// Crease patterns for tests.
#pragma once
#include "plico/fold/planar_faces.h"

namespace plico {

// Concentric squares in turn mountain and valley, and their diagonals: curved when folded, so its panels must bend (a
// hypar).
inline CreasePattern pleated_square(int rings) {
  CreasePattern sheet;
  sheet.vertices.emplace_back(0, 0);
  for (int r = 1; r <= rings; ++r)
    for (const Vec2& corner : {Vec2(r, r), Vec2(-r, r), Vec2(-r, -r), Vec2(r, -r)}) sheet.vertices.push_back(corner);
  const auto vertex = [](int r, int i) { return r == 0 ? 0 : 4 * (r - 1) + i % 4 + 1; };
  for (int r = 1; r <= rings; ++r)
    for (int i = 0; i < 4; ++i) {
      const bool border = r == rings;
      const double ring = r % 2 == 1 ? kPi : -kPi, diagonal = i % 2 ? kPi : -kPi;
      sheet.edges.push_back(
          {vertex(r, i), vertex(r, i + 1), border ? Assignment::Boundary : assignment_of(ring), border ? 0 : ring});
      sheet.edges.push_back({vertex(r - 1, i), vertex(r, i), assignment_of(diagonal), diagonal});
    }
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

}  // namespace plico
