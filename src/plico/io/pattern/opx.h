// .opx, ORIPA's own file: an XML list of OriLineProxy objects with type, x0, y0, x1, y1, of which zeros are left out;
// type 0 auxiliary, 1 border, 2 mountain, 3 valley. No angles, no panels; y points down.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/pattern/imported_pattern.h"

namespace plico {

// As read_cp. Throws InvalidInput ("opx/...", "read/xml", "pattern/...") with file and line.
ImportedPattern read_opx(std::string_view bytes, const std::string& name = "input", const DrawingOptions& options = {});

}  // namespace plico
