// .ori and .trj, the files of the dissertation's author, as text and as JSON (.ori.json, .trj.json): triangulated
// crease patterns with a tree of panels, and motions of them. Layout: [Xi17]'s programs and viewer.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/fold/folding_path.h"
#include "plico/io/pattern/imported_pattern.h"

namespace plico {

struct OriFile {
  ImportedPattern pattern;  // edges: the file's creases in their order, then the other sides of its triangles
  std::vector<int> sign;    // of each crease of the file: +1 where its positive angles are valleys, -1 where mountains
};

// Vertices; creases "v1 v2 angle face parent" (radians); triangles "3 a b c parent crease". The child turns by the
// angle about v1 -> v2, so on which side of the crease it lies decides what is a valley. Sheets lie in xy (front +z) or
// in xz (front +y, read as x, -z). Angles within 5e-6 of a multiple of 90 degrees are meant to be it, which a note
// says. Throws InvalidInput ("ori/...", "read/...") with the place.
OriFile read_ori(std::string_view bytes, const std::string& name = "input");

// One configuration a line in degrees, or JSON "trajs" in radians; at equal times. For the hinges of the sheet's
// linkage. Throws InvalidInput ("trj/...", "read/...") with the place: a frame that does not fit, an angle beyond 180
// degrees, less than two frames.
FoldingPath read_trj(std::string_view bytes, const OriFile& ori, const std::string& name = "input");

}  // namespace plico
