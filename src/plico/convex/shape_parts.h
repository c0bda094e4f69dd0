// The parts of a shape that is given as polygons of any kind.
#pragma once
#include <string>
#include <vector>

#include "plico/convex/shells.h"
#include "plico/mesh/soup.h"

namespace plico {

// Faces that hang together at corners with equal coordinates are a part, numbered by first face and named A, B ... as
// in mesh/segmentation.h. O(n log n).
std::vector<ShapePart> parts_by_components(const PolygonSoup& soup);

// Parts by a group for every face, in the order of the names; a part without a name is called "part", and names that
// stand twice get a number. Groups without faces make no part. Throws InvalidInput when there is not one group a face.
std::vector<ShapePart> parts_by_groups(const PolygonSoup& soup, const std::vector<int>& group_of_face,
                                       const std::vector<std::string>& names);

}  // namespace plico
