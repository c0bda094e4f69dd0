// Every sample shape under a name: what `plico sample` makes, and what tests and benchmarks run on.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

struct NamedShape {
  std::string name, description;
  bool has_face_count = false;  // made with as many faces as asked for, or as near as its pattern allows
};

const std::vector<NamedShape>& named_shapes();

struct ShapeOptions {
  int faces = 0;           // asked for, 0: the shape's own default; only for shapes with has_face_count
  double variety = 0;      // of creatures: how much proportions stray, in [0, 1]
  std::uint64_t seed = 1;  // of creatures: which straying animal
};

// Throws InvalidOption for an unknown name, a face count that the shape cannot have, or variety where there is none.
PolygonSoup make_shape(std::string_view name, const ShapeOptions& options = {});

}  // namespace plico
