// Animated binary glTF 2.0 (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html): opens in browsers, Blender,
// slide programs. One node a panel, nested along the tree, each turned about its hinge by one rotation channel, so the
// animation is the motion itself and not samples of it.
#pragma once
#include <string>

#include "plico/fold/folding_path.h"

namespace plico {

struct GltfOptions {
  double metres_per_unit = 0.001;  // glTF is in metres; the default reads the linkage's unit as millimetres
  double seconds = 4;              // from flat to folded, above 0
};

// The bytes of a .glb file, the same for the same input. glTF turns along the shorter arc between two keys, so a step
// of more than 120 degrees gets keys in between. Front and back are materials of their own; panels of a linkage with
// `thickness` are plates around z = 0. The sheet's +z is glTF's +y. O(panels + waypoints * hinges). Throws InvalidInput
// for a motion beyond the limits of a hinge.
std::string write_glb(const Linkage& linkage, const FoldingPath& path, const GltfOptions& options = {});

}  // namespace plico
