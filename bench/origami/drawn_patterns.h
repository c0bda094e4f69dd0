// Crease patterns as people drew them: a row for each file of a folder, then how many get how far.
#pragma once
#include <string>

namespace plico::bench {

// Reads and plans every FOLD, .cp, .opx, .ori and SVG file of the folder as `plico fold` does, for 20 s each at most.
// Returns an exit code.
int drawn_patterns(const std::string& folder);

}  // namespace plico::bench
