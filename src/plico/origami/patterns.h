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

struct YoshimuraOptions {
  int columns = 6, rows = 4;            // bases of triangles in a line, lines of triangles, at least 1 each
  double sector = radians(45);          // base angle of a triangle, in (0, pi/2)
  double diagonal_angle = radians(30);  // size of the goal of the (mountain) diagonals, in [0, pi]
};

// Lines of isosceles triangles with base 1, every other line shifted by half a base. With d = diagonal and s = sector:
// the straight creases fold by h = 2 atan(cos s tan(d / 2)); the goal closes exactly. (columns - 1)(rows - 1) real
// vertices, all of degree 6, and rows (2 columns - 1) + columns (rows - 1) creases.
CreasePattern yoshimura(const YoshimuraOptions& options = {});

// The diagonals' angle at which the left and right ends of the folded sheet meet and it becomes a tube: every column
// turns by 4 asin(sin s sin(d / 2)). More than this runs into itself; pi when the sheet is too narrow to become a tube.
double yoshimura_tube_angle(int columns, double sector);

}  // namespace plico
