// The faces that straight edges cut out of the plane.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

// The bounded faces of a planar straight-line graph, counter-clockwise, in the order of their first edges.
//   - Edges with the same face on both sides (one end free, or a bridge) border no face.
//   - A face all of whose edges are boundary is a hole when a face with a crease lies beyond one of them.
//   - A piece that floats inside a face does not cut it: it has its own faces.
// Decisions are exact. Throws InvalidInput when an edge has no length, or two edges meet anywhere but at a vertex of
// both. O(n log n) when edges are short against the drawing.
std::vector<std::vector<int>> planar_faces(const std::vector<Vec2>& vertices, const std::vector<Crease>& edges);

// All pairs of edges that meet anywhere but at a vertex of both, the lower first, ascending. Edges without a length
// take no part. Decisions are exact. O(n log n) when edges are short against the drawing.
std::vector<std::pair<int, int>> clashing_edges(const std::vector<Vec2>& vertices, const std::vector<Crease>& edges);

// "near 1.5 2": where in a drawing a message is about.
std::string near(const Vec2& p);

// Where two such edges meet, rounded; of edges that lie on each other, an end of one that is on the other.
Vec2 meeting_point(const std::vector<Vec2>& vertices, const Crease& e, const Crease& f);

}  // namespace plico
