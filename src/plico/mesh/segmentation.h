// A mesh cut into parts: which part every face belongs to, and what the parts are called.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// Made by the folder segment, by groups of a file or by the user; every way of cutting a mesh ends here.
struct Segmentation {
  std::vector<int> part;           // of each face, in [0, num_parts()); every part has a face
  std::vector<std::string> names;  // one a part: not empty, no two the same

  int num_parts() const { return static_cast<int>(names.size()); }
};

// The faces of each part, ascending. O(faces).
std::vector<std::vector<FaceId>> faces_of_parts(const Segmentation& segmentation);

// The edges between faces of two parts, ascending. O(edges).
std::vector<EdgeId> seams(const Mesh& mesh, const Segmentation& segmentation);

// Parts from any labels, one a face: equal labels make a part. Parts are numbered by area, the largest first (ties: the
// first face), and named A, B ... Z, AA ... O(n log n). Throws InvalidInput when there is not one label a face.
Segmentation segmentation_by_labels(const Mesh& mesh, const std::vector<int>& labels);

// The nth name of a part: A, B ... Z, AA, AB ...
std::string part_name(int n);

}  // namespace plico
