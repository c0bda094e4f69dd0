// DXF AC1015 (AutoCAD 2000), millimetres declared, for cutting machines and CAD.
#pragma once
#include <string>

#include "plico/io/page/drawing.h"

namespace plico {

// Layers CUT, MOUNTAIN, VALLEY, MARK, TEXT; every stroke is one LWPOLYLINE, closed for the outlines of parts. Letters
// are outlines, since machines have no fonts. No splines, no blocks. Deterministic bytes.
std::string write_dxf(const Drawing& drawing);

}  // namespace plico
