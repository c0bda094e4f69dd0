// Simple polygons in the plane: measures (rounded) and decisions (exact). Vertices are counter-clockwise unless said.
// Convex ones: convex2.h.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

double signed_area(std::span<const Vec2> polygon);  // positive when counter-clockwise
double perimeter(std::span<const Vec2> polygon);
Vec2 centroid(std::span<const Vec2> polygon);  // of the area; of the vertices when the area is 0

bool is_convex(std::span<const Vec2> polygon);  // exact; collinear vertices allowed

// Ear clipping with exact decisions: corner indices, n - 2 triangles, each counter-clockwise. A polygon that is not
// simple still gets n - 2 triangles, some turned over. O(n^2).
std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon);

}  // namespace plico
