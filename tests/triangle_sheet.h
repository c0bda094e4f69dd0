// A triangulated height field to test with.
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

// A sheet over n x n unit squares, each cut in two, at height(x, y).
template <class Height>
Mesh triangle_sheet(int n, const Height& height) {
  PolygonSoup soup;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y) soup.points.emplace_back(x, y, height(x, y));
  const auto at = [n](int x, int y) { return x * (n + 1) + y; };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) {
      soup.add_face({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      soup.add_face({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return Mesh(soup);
}

}  // namespace plico
