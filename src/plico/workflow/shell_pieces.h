// A shape as convex pieces that are built one by one and glued face to face ([Xi17] 5.5, 5.7).
#pragma once
#include <string>
#include <vector>

#include "plico/segment/convexity.h"
#include "plico/workflow/kit.h"
#include "plico/workflow/shell_shape.h"

namespace plico {

struct ShellPieces {
  Mesh mesh;            // all shells, one component each, neighbouring triangles in one plane as one face
  Segmentation pieces;  // one a shell, named after its part
  std::vector<Joint> joints;
  JudgedShells judged;
  std::vector<std::string> notes;  // parts that were dropped or lost; contacts that lie on no single facet
};

// Disjoint shells of the parts, judged, and where they touch. Throws InvalidInput ("shells/lost") when no shell is
// left.
ShellPieces shell_pieces(const std::vector<ShapePart>& parts, const ShellOptions& options = {}, const Run& run = {});

// Nearly convex parts of a mesh (segment/convexity.h), the largest first, named A, B ...
std::vector<ShapePart> nearly_convex_parts(const Mesh& mesh, const ConvexityOptions& options = {}, const Run& run = {});

}  // namespace plico
