// Tessellations of any size, with known motions.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

struct MiuraOptions {
  int columns = 3, rows = 3;     // parallelograms, at least 1 each
  double sector = radians(65);   // acute angle of a parallelogram, in (0, pi/2)
  double zigzag_angle = kPi;     // goal of the zigzag creases, in [0, pi]
  double width = 1, height = 1;  // of a parallelogram: straight side and distance of the straight lines, > 0
  bool facet_diagonals = false;  // one flat crease across every parallelogram
};

// Goals obey tan(straight / 2) = cos(sector) tan(zigzag / 2), so the goal closes exactly.
// (columns - 1)(rows - 1) real vertices, rows (columns - 1) + columns (rows - 1) creases without diagonals.
CreasePattern miura(const MiuraOptions& options = {});

struct WaterbombOptions {
  int columns = 4, rows = 6;            // unit squares, even, at least 2 each
  double diagonal_angle = radians(45);  // size of the goal of the (mountain) diagonals, in [0, pi]
  bool facet_horizontals = false;       // the flat creases along the lines of the centres
};

// The uniform waterbomb tessellation. With t = tan(diagonal / 2): verticals inside a unit a = 2 atan(t / sqrt 2),
// horizontals h = 2 atan(sqrt 2 t), verticals between units 2h - a; the goal closes exactly (Imada & Tachi 2022,
// cylinder solution). (columns - 1)(rows - 1) real vertices.
CreasePattern waterbomb(const WaterbombOptions& options = {});

}  // namespace plico
