// The rotations and reflections that take a drawing to itself, as nearly as it was drawn.
#pragma once
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

struct DrawingSymmetry {
  Eigen::Matrix2d turn;     // about the centre, orthogonal; a reflection when its determinant is -1
  std::vector<int> vertex;  // v goes to vertex[v]
};

// About the mean of the vertices; the identity first, a group. Edges go to edges of the same assignment and goal, and
// vertices to within `off` units of vertices. O(candidates * n log n), the candidates being those that take one vertex
// to another at its distance.
std::vector<DrawingSymmetry> drawing_symmetries(const CreasePattern& sheet, double off);

// Every vertex moved to the mean of the places that the symmetries ask for.
std::vector<Vec2> symmetrized(const std::vector<Vec2>& vertices, const std::vector<DrawingSymmetry>& group);

}  // namespace plico
