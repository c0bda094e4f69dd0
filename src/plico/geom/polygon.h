// Simple polygons in the plane: measures (rounded) and decisions (exact). Vertices are counter-clockwise unless said.
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

// Do two convex counter-clockwise polygons share an interior point? Touching is not sharing. Exact. O(n m).
bool interiors_overlap_convex(std::span<const Vec2> a, std::span<const Vec2> b);

// Counter-clockwise hull without collinear points (Andrew's monotone chain, exact turns). O(n log n).
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

// The rectangle of least area around a convex counter-clockwise polygon: turned by `angle` radians. O(n^2).
struct TurnedRectangle {
  double angle = 0;  // rotate the polygon by -angle to make the rectangle upright
  Vec2 size = Vec2::Zero();
};
TurnedRectangle least_area_rectangle(std::span<const Vec2> hull);

}  // namespace plico
