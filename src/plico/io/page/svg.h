// SVG 1.1 in millimetres: one drawing a file, layers as Inkscape layers, text as text.
#pragma once
#include <string>

#include "plico/io/page/drawing.h"

namespace plico {

// Width, height and viewBox are the page in millimetres; groups CUT, MOUNTAIN, VALLEY, MARK, TEXT, cuts on top.
// Deterministic bytes.
std::string write_svg(const Drawing& drawing);

}  // namespace plico
