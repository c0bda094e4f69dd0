// A mesh with fewer faces, and what that did to its shape.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/simplify.h"

namespace plico {

// Left and right alike where the shape is, or never, or a reason to say that it is not.
enum class Halves { Auto, Free, Alike };

// What models in files want: sharp edges stay, triangles are as even as that allows.
inline SimplifyOptions kept_sharp(int faces) { return {.faces = faces, .evenness = 0.003, .keep_sharp = true}; }

struct SimplifiedMesh {
  Mesh mesh;
  int faces_before = 0;            // triangles, once polygons are cut
  double distance = 0;             // the greatest of a vertex of either surface from the other, the mesh's unit
  bool symmetric = false;          // left and right are equal, triangle by triangle
  int crossings = 0;               // pairs of faces that pass through each other and did not before
  std::vector<std::string> notes;  // what was not as asked for; sentences
};

// Polygons are cut into triangles first. A mesh that has no more faces than asked for is returned as it is. Where the
// shape is its own mirror image, to 0.5 % of its diagonal, so is the result; if that alone makes faces pass through
// each other, it is not. Throws as simplified().
SimplifiedMesh simplify_mesh(const Mesh& mesh, const SimplifyOptions& options, Halves wish = Halves::Auto);

}  // namespace plico
