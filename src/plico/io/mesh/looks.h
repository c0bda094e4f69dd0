// What a file says about the looks of its faces, before pictures beside it are read.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "plico/base/picture.h"

namespace plico {

inline const Vec2 kNoUv = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());

struct Material {
  std::string name = {};
  Color color = kWhite;  // of faces without a picture; tints the picture when `tints`
  bool tints = false;
  std::string picture = {};                          // the name of a file, as written; empty when there is none
  std::string picture_bytes = {};                    // the file itself, when it is part of the mesh's
  Vec2 scale = Vec2::Ones(), offset = Vec2::Zero();  // of the picture: uv * scale + offset counts
};

struct Looks {
  std::vector<std::string> libraries;  // files of materials, as written
  std::vector<Material> materials;     // of an OBJ file only names, until its libraries are read
  std::vector<int> material;           // of each face, -1 for none; may be shorter than there are faces
  std::vector<Vec2> uv;                // of each corner of the soup, kNoUv where there is none; or empty
  std::vector<Color> colors;           // of each corner; or empty

  int number_of(const std::string& name);  // of the material of that name, a new one when there is none
};

}  // namespace plico
