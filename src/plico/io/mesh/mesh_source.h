// What a mesh reader returns: the polygons, and where in the file each of them stands, for messages.
#pragma once
#include <string>
#include <vector>

#include "plico/io/mesh/looks.h"
#include "plico/mesh/soup.h"

namespace plico {

// Files that promise more faces or vertices than this are refused before anything is allocated.
constexpr int kMaxElements = 50'000'000;

struct MeshSource {
  PolygonSoup soup;              // every index in range; nothing else is promised (mesh/check.h)
  std::string name;              // of the file
  bool binary = false;           // places are byte offsets, otherwise line numbers from 1
  std::vector<int> point_place;  // one per point: the line or byte at which it is given
  std::vector<int> face_place;   // one per face
  Looks looks;

  std::string place(int where) const;  // "bunny.obj:214" or "bunny.stl: byte 1084"
};

}  // namespace plico
