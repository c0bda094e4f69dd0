// .cp, the line list of ORIPA and its kin: "type x1 y1 x2 y2" a line; type 0 none, 1 border, 2 mountain, 3 valley,
// 4 auxiliary. No angles, no panels; y points down.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/pattern/imported_pattern.h"

namespace plico {

// The drawing as it looks on the screen: y is turned up. Mountains and valleys are folded flat, 180 degrees. Throws
// InvalidInput ("cp/...", "read/...", "pattern/...") with file and line.
ImportedPattern read_cp(std::string_view bytes, const std::string& name = "input", const DrawingOptions& options = {});

// Angles and panels are lost: the format has none. Reads back to the same vertices.
std::string write_cp(const CreasePattern& sheet);

}  // namespace plico
