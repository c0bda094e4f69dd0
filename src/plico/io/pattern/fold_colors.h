// Colours of panels in FOLD files: the key faces_plico:color, one "#rrggbb" a face.
#pragma once
#include <vector>

#include "plico/base/picture.h"
#include "plico/io/pattern/fold.h"

namespace plico {

void set_colors(FoldFile& file, const std::vector<Color>& colors);  // none: the key goes
// Of each panel; empty when the file has none. Throws InvalidInput when they are not one a face.
std::vector<Color> colors_of(const FoldFile& file);

}  // namespace plico
