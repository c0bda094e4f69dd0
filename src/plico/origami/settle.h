// The least move of the vertices, in the plane, that lets a drawn crease pattern fold.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/crease_pattern.h"
#include "plico/fold/linkage.h"

namespace plico {

struct SettleOptions {
  int states = 1;          // on the way from flat to the goal that are closed as well; at least 0
  double drawn = 0.02;     // how inexact the drawing may be, of the shortest edge: lines that are straight, places that
                           // are symmetric; above 0
  double most_move = 0.2;  // of a vertex, of the shortest edge: what would move farther does not settle; above 0
  double tolerance = 1e-12;  // radians, of the worst residual of the goal and of each state; above 0
  int max_steps = 60;        // of Gauss-Newton
  bool keep_symmetry = true;
};

struct Settled {
  CreasePattern sheet;                // moved; goals as they were, or by half a degree where not 0 or 180 degrees
  bool closed = false;                // goal and states, to the tolerance; else the sheet is as given
  double open_before = 0, open = 0;   // residual of the goal, radians
  double move = 0;                    // of the vertex that moved farthest, units
  int vertex = -1;                    // that one; -1 when none moved
  double move_share = 0;              // of the shortest edge
  int symmetries = 1;                 // of the drawing, that were kept; 1: none but the identity
  int lines = 0;                      // of two edges or more, that were kept straight
  std::vector<Configuration> states;  // that were closed on the way; fewer than asked for when none was found
  int steps = 0;
};

// Closing the goal alone is not enough: a mesh of quadrilaterals that folds flat is not rigid on the way when its
// vertices are a little off, since what they ask of the panels' creases no longer agrees. For flat-foldable ones one
// closed state between suffices ([Tac09]). So vertices and the fold angles of the states are the unknowns of a
// minimum-norm Gauss-Newton iteration on the loops of the goal and of each state, and on straight_lines staying
// straight. A turn of a crease costs little against a move of a vertex; goals of 0 and 180 degrees are fixed. States
// are looked for with loops left open by about as much as the goal is; a sheet that does not leave flat has none.
// A drawing with symmetries is made symmetric first, and stays so. Deterministic. O(steps) sparse factorizations.
Settled settle(const CreasePattern& sheet, const SettleOptions& options = {}, const Run& run = {});

// Length of the shortest edge, units; 0 without edges.
double shortest_edge(const CreasePattern& sheet);

}  // namespace plico
