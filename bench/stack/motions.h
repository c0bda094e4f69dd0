// How many stacked chains unpack into their shape.
#pragma once
#include <string>

#include "table.h"

namespace plico::bench {

// `folder` of meshes may be empty; `quick` looks at every eighth, 10 s each instead of 60.
Table motions(const std::string& folder, bool quick);

}  // namespace plico::bench
