// Crease patterns in SVG with the meaning that Origami Simulator gives to strokes: #f00 mountain, #00f valley, #000
// border, #0f0 cut, #ff0 crease that stays flat, #f0f hinge that turns freely; opacity x 180 degrees is the fold angle.
// (Pages for printing are another thing: svg.h.)
#pragma once
#include <string>
#include <string_view>

#include "plico/io/pattern/imported_pattern.h"

namespace plico {

// Lines, polylines, polygons, rectangles and straight paths, in groups, with transforms; the stroke from attributes,
// style="" or simple rules of a <style> element. Line ends within 1/1000 of the drawing are joined, y is turned up.
// Throws InvalidInput ("svg/...", "read/xml", "pattern/...") with file and line: curves are not creases.
ImportedPattern read_svg_pattern(std::string_view bytes, const std::string& name = "input");

// One <line> an edge; reads back to the same vertices and letters (J as F) and to the same angles but for rounding.
std::string write_svg_pattern(const CreasePattern& sheet);

}  // namespace plico
