// Polygons as a file gives them, before anybody has looked whether they make a surface.
#pragma once
#include <span>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

struct PolygonSoup {
  std::vector<Vec3> points;        // n x 3, the mesh's own unit
  std::vector<int> corners;        // point indices of all faces, one face after the other
  std::vector<int> offsets = {0};  // face f has corners [offsets[f], offsets[f + 1])

  int num_points() const { return static_cast<int>(points.size()); }
  int num_faces() const { return static_cast<int>(offsets.size()) - 1; }
  std::span<const int> face(int f) const {
    return {corners.data() + offsets[f], static_cast<std::size_t>(offsets[f + 1] - offsets[f])};
  }
  void add_face(std::span<const int> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<int>(corners.size()));
  }
  void add_face(std::initializer_list<int> face) { add_face(std::span<const int>(face.begin(), face.size())); }
};

}  // namespace plico
