// Several crease patterns in one drawing: each folds as far as it can, whatever stops the others.
#pragma once
#include "plico/workflow/plan_motion.h"

namespace plico {

// As plan_drawn, for each connected sheet of the drawing by itself; one sheet alone is planned as plan_drawn does. The
// motion folds one sheet after the other, in the order of their first panels, and its proof is of all of it. `progress`
// is share_of_way of all of them, the ending the worst one; notes begin with "sheet 2: ", counted from 1, and count
// creases, vertices and panels within that sheet. Of a drawing with several sheets there is one motion, whatever
// options.alternatives is.
MotionOutcome plan_sheets(const CreasePattern& drawing, const MotionOptions& options = {}, const Run& run = {});

}  // namespace plico
