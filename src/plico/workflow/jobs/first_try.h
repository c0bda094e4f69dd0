// What to tell someone whose crease pattern stays flat at the first try.
#pragma once
#include <string>

#include "plico/fold/crease_pattern.h"
#include "plico/workflow/plan_motion.h"

namespace plico::jobs {

inline constexpr double kStaysFlat = 0.01;  // of the way: a sheet that folds less has not moved

// Creases without mountain or valley, which turn freely and have no goal.
int num_unassigned(const CreasePattern& sheet);

// One sentence for a sheet that stays flat: what stops it, where, and one command to try. `file` is what was read. The
// reasons, in this order: creases without mountain or valley, the time was up, a goal that nearly closes, a vertex that
// cannot fold as it says, a vertex that is locked.
std::string tell_what_stops(const CreasePattern& sheet, const MotionOutcome& outcome, const std::string& file);

}  // namespace plico::jobs
