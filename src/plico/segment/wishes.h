// What people say about faces: these stay together, these come apart, the part with this one is called so.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plico/mesh/segmentation.h"
#include "plico/segment/dual_graph.h"

namespace plico {

struct FaceWishes {
  std::vector<std::vector<int>> keep;   // the faces of each group end in one part
  std::vector<std::vector<int>> apart;  // no two faces of a group end in one part

  bool any() const { return !keep.empty() || !apart.empty(); }
};

// Faces as users write them: "3,17-20". `option` is named in errors. Throws InvalidOption.
std::vector<int> face_list(const std::string& text, std::string_view option);

// Throws InvalidOption for faces that are not there, alone, or to be kept together and apart.
void check(const FaceWishes& wishes, int num_faces);

// The pairs of all groups that come apart, smaller first.
std::vector<std::pair<int, int>> pairs_apart(const FaceWishes& wishes);

// No seam may cross the shortest ways between faces that are kept together; ways go round faces that must be apart
// from the group. Throws InvalidOption when there is no way. O(groups n log n).
void hold_together(DualGraph& graph, const FaceWishes& wishes);

// Throws InvalidOption when a group that is kept lies in two parts: what must come apart is in its way.
void check_kept(const FaceWishes& wishes, const std::vector<int>& part);

// Names from a file with lines "FACE NAME": the part that holds the face is called so, other parts keep their names.
// Throws InvalidInput ("segment/names") for faces that are not there, a part or a name told twice, or lines of another
// kind; `name` is the file's.
void name_parts(Segmentation& parts, std::string_view bytes, const std::string& name);

}  // namespace plico
