// From lines as people draw them to a crease pattern: ends that nearly meet are joined, lines are split where they meet
// and lines drawn twice become one. Nothing is mended in silence: the counts say what was done.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/drawn_line.h"

namespace plico {

struct ArrangeOptions {
  double merge = 1e-6;  // ends closer than this fraction of the drawing's longer side become one; in [1e-9, 0.1]
  bool found = false;   // of the likely distances (merge_distance.h) the first that leaves the fewest ends loose
  double distance = 0;  // in the drawing's unit: asked for, instead of both; 0: not
};

struct Arrangement {
  CreasePattern sheet;     // with its panels
  std::vector<int> drawn;  // of each edge: the line it is a piece of
  double distance = 0;     // ends closer than this were joined, in the drawing's unit
  bool customary = true;   // it is the one asked for, not one found in a gap

  int joined_ends = 0;   // moved onto another end
  int dropped_dots = 0;  // lines no longer than `distance`
  int crossings = 0;     // points where lines cross and no line ended
  int tees = 0;          // splits at the end of another line
  int duplicates = 0;    // pieces drawn again
  int conflicts = 0;     // duplicates with another letter or angle; borders win, then cuts, creases, flat lines
  int conflict_at = 0;   // place of the first of these
  int rims = 0;          // creases with a panel on one side only, which became boundary
  int loose = 0;         // lines with no panel beside them, or the same panel twice: they fold nothing
};

// O((n + k) log n) for n lines of similar length and k points where they meet. Throws InvalidInput ("pattern/...") when
// nothing is drawn, no panel is enclosed, or the drawing is so tangled that it does not come to an end.
Arrangement arrange_lines(const std::vector<DrawnLine>& lines, const ArrangeOptions& options = {});

// One sentence for everything that was done; empty when the drawing was clean. `place` names a DrawnLine::place.
std::vector<std::string> notes(const Arrangement& arrangement, const std::string& place = "line");

}  // namespace plico
