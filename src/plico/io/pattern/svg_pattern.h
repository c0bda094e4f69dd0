// Crease patterns in SVG with the meaning that Origami Simulator gives to strokes: #f00 mountain, #00f valley, #000
// border, #0f0 cut, #ff0 crease that stays flat, #f0f hinge that turns freely; opacity x 180 degrees is the fold angle.
// (Pages for printing are another thing: svg.h.)
#pragma once
#include <string>
#include <string_view>

#include "plico/io/pattern/imported_pattern.h"

namespace plico {

// Every shape, in groups and by <use>, with transforms; the stroke from attributes, style="", <style> elements or the
// groups around. Curves become chains of lines (options.flatten), line ends that nearly meet are joined
// (options.merge), colours that are nearly one of the six are taken for it; y is turned up. The notes say so.
// Throws InvalidInput ("svg/...", "read/xml", "pattern/...") with file and line.
ImportedPattern read_svg_pattern(std::string_view bytes, const std::string& name = "input",
                                 const DrawingOptions& options = {});

// One <line> an edge; reads back to the same vertices and letters (J as F) and to the same angles but for rounding.
std::string write_svg_pattern(const CreasePattern& sheet);

}  // namespace plico
