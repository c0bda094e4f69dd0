// SVG 1.1 in millimetres: one drawing a file, or several beside each other; layers as Inkscape layers, text as text.
#pragma once
#include <string>
#include <vector>

#include "plico/io/page/drawing.h"

namespace plico {

// Width, height and viewBox are the page in millimetres; groups CUT, MOUNTAIN, VALLEY, MARK, TEXT, cuts on top.
// Deterministic bytes.
std::string write_svg(const Drawing& drawing);

// All pages in one file, in a row, 10 mm apart: pages to Inkscape, one wide drawing to other programs. Each layer is
// one group, with a group for each page in it.
std::string write_svg(const std::vector<Drawing>& pages);

}  // namespace plico
