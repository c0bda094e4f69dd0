// From a crease pattern as somebody drew it to a proven motion.
#pragma once
#include "plico/workflow/plan_motion.h"

namespace plico {

inline constexpr double kSettledUnasked = 1e-3;  // of the shortest edge: how far vertices may be moved without asking

// As plan_origami, and when the goal of the drawing stays open by little, as goals of rounded drawings do, its vertices
// are settled first (origami/settle.h), by at most kSettledUnasked. The settled sheet is then that of the outcome, and
// a note has its largest move; what the drawing itself folds farther, it folds as drawn. Plans twice when a settled
// sheet stops early. Where all that stops early and options.deformation allows, the drawing is folded with loops open
// by so little (go_deformed); that is taken when it goes farther by a hundredth of the way.
MotionOutcome plan_drawn(const CreasePattern& sheet, const MotionOptions& options = {}, const Run& run = {});

}  // namespace plico
