// A polygon in space cut into triangles.
#pragma once
#include <array>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

// n - 2 triangles of point indices, turning like the face; none for a face of fewer than 3 corners. A simple polygon is
// cut inside itself, seen along its normal; no vertices are added. O(n^2).
std::vector<std::array<int, 3>> triangulate_face(const PolygonSoup& soup, int face);

// Twice the face's vector area (Newell's sum), taken about its first corner; zero for fewer than 3 corners.
Vec3 twice_vector_area(const PolygonSoup& soup, int face);

// The face seen along the axis of its greatest area, counter-clockwise when the vector area is not zero.
std::vector<Vec2> projected(const PolygonSoup& soup, int face);

}  // namespace plico
