// Libraries of materials beside OBJ files: `newmtl`, `Kd` and `map_Kd`; everything else is passed over.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/io/mesh/looks.h"

namespace plico {

// In the order of the file. Names, also of pictures, go to the end of their line; of the options of map_Kd, -s and -o
// (scale and offset) count. Throws InvalidInput with "name:line" for a colour that is none. O(bytes).
std::vector<Material> read_mtl(std::string_view bytes, const std::string& name);

}  // namespace plico
