// Parts that somebody else has made: components of the mesh, groups of its file, labels in a file of their own.
#pragma once
#include <string>
#include <vector>

#include "plico/mesh/segmentation.h"

namespace plico {

// One part a component. O(n log n).
Segmentation by_components(const Mesh& mesh);

// One part for every connected piece of a group, named after it; further pieces of one group are "leg-2", "leg-3" ...
// by area. `group` has one entry a face, an index into `names`; names that are empty stand for parts without a name,
// which are called A, B ... Parts are numbered by area, the largest first. O(n log n). Throws InvalidInput when there
// is not one group a face.
Segmentation by_groups(const Mesh& mesh, const std::vector<int>& group, const std::vector<std::string>& names);

// One part for every connected piece of faces with equal labels, called A, B ... by area. O(n log n).
Segmentation by_labels(const Mesh& mesh, const std::vector<int>& labels);

// The connected pieces of equal labels, numbered by first face: one entry a face. O(n).
std::vector<int> connected_pieces(const Mesh& mesh, const std::vector<int>& labels);

}  // namespace plico
