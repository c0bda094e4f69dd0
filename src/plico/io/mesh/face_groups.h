// Which group every face of a file belongs to: names in an OBJ file, or a file of labels.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plico {

struct FaceGroups {
  std::vector<int> of_face;        // an index into names
  std::vector<std::string> names;  // in the order in which they appear; empty for faces before the first name
};

// Groups of the lines "g NAME..." of an OBJ file, or of its lines "o NAME" when it has no "g". Throws InvalidInput when
// it has neither.
FaceGroups read_obj_groups(std::string_view bytes, const std::string& name);

// One label, a word or a number, a line and a face, as in .seg files of segmentation benchmarks.
FaceGroups read_face_labels(std::string_view bytes, const std::string& name);

}  // namespace plico
