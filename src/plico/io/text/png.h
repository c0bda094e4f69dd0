// Pictures as PNG files.
#pragma once
#include <string>

#include "plico/base/picture.h"

namespace plico {

// The bytes of a PNG file; `effort` in [1, 9] is spent on making it small.
std::string write_png(const Picture& picture, int effort = 9);

}  // namespace plico
