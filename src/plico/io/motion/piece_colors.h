// A colour for every piece of what folds, so that parts are told apart where they lie or stand side by side.
#pragma once
#include <vector>

#include "plico/base/picture.h"
#include "plico/fold/linkage.h"

namespace plico {

// Of each panel, ten colours in turn by piece; empty for one piece. O(panels).
std::vector<Color> piece_colors(const Linkage& linkage);

}  // namespace plico
