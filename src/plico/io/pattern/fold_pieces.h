// Kits in FOLD files: every piece of the net in frames of its own, with its own motion.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plico/io/pattern/fold.h"

namespace plico {

// Makes the file one of a kit, or changes its motions: a title and a motion, or none, for each part of file.net. Throws
// InvalidInput ("fold/piece") when two parts are joined by a fold.
void set_pieces(FoldFile& file, const std::vector<std::string>& titles,
                const std::vector<std::optional<FoldingPath>>& paths);

// Every piece as a file of its own: its sheet and its motion. Mesh numbers, folded form and joints stay behind, since
// they are of the whole. O(size).
std::vector<FoldFile> piece_files(const FoldFile& kit);

}  // namespace plico
