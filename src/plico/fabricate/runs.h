// A chain of squares as sheets to cut: its strip almost never lies flat without lying over itself, so it is cut into
// runs that do and that fit a page. A run is one piece of fabric or film; its panels are glued on, and runs are joined
// at numbered joints.
#pragma once
#include "plico/fabricate/page.h"
#include "plico/fold/crease_pattern.h"
#include "plico/fold/page_layout.h"

namespace plico {

struct RunOptions {
  double side = 25;  // of a square, millimetres, above 0
  double trim = 0;   // of every side of a panel, millimetres, in [0, side / 2)
  PageOptions page;
};

// The strip has square faces in the order of the chain; edge h lies between the faces h and h + 1, and comes before all
// that are no hinges. Each run is as long as can be and a part of its own; runs stand on pages in rows, in order.
//   - Outlines have the full squares, marks the panels that are glued on, trimmed; every panel has its number, from 0.
//   - Folds have the angles of the shape. Where runs are to be joined, both sides have the joint's name: "J12" is
//   hinge 12.
// Throws InvalidOption for a square that no page holds. O(n log n).
PageLayout lay_out_runs(const CreasePattern& strip, const RunOptions& options);

}  // namespace plico
