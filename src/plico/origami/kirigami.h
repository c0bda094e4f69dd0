// Sheets with slits and holes, with known motions.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

struct HoneycombOptions {
  int columns = 3, rows = 4;  // hexagons in a line, strips, at least 1 each
  double wall_angle =
      radians(60);           // goal by which the walls of a strip turn, in [0, pi/2]; 60 degrees: regular hexagons
  double strip_angle = kPi;  // goal between strips, in [0, pi]; pi: the strips stand back to back
  double height = 1;         // of a strip, in walls, above 0
};

// Strips of 4 columns + 1 walls of width 1, each a wave of half hexagons. A strip hangs on the next one by every fourth
// wall and is slit from it elsewhere; folded to and fro they close to hexagons. All creases of one kind lie in lines
// that stay lines, so every choice of the two angles closes. No real vertices, one loop a slit.
CreasePattern honeycomb(const HoneycombOptions& options = {});

struct RotatingSquaresOptions {
  int columns = 5, rows = 5;  // of the checkerboard, at least 2 each
  double middle_angle = kPi;  // goal of the creases in the middle of the gussets, in [0, pi]; pi: the squares close up
  double gusset = 0.5;        // its legs, in sides of a square, in (0, 1]
};

// The black squares of a checkerboard, which hang together at their corners only: there two triangles, a gusset, join
// them across one of the white squares, what is left of which is a hole. As the gussets fold out of the plane the
// squares stay in it and turn against each other, until all white has gone. With m in the middle, the sides of a gusset
// fold by s, tan s = sqrt 2 tan(m / 2), and two squares enclose asin(cos(m / 2) / sqrt 2) twice; the goal closes
// exactly. 3 (columns - 1)(rows - 1) creases, no real vertices, one loop of 12 creases a white square inside.
CreasePattern rotating_squares(const RotatingSquaresOptions& options = {});

// A card with three boxes between slits that pop up as it folds; all creases turn by `angle`, radians in [0, pi].
CreasePattern pop_up(double angle = kPi / 2);

}  // namespace plico
