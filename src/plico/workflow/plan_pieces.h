// The motion of a kit is planned piece by piece: what one piece does is nothing to the others.
#pragma once
#include "plico/fold/unfolding.h"
#include "plico/workflow/plan_motion.h"

namespace plico {

// Plans every piece of a net as plan() does, pieces side by side on run.threads threads, and joins the motions: all
// pieces move at the same time. The whole is proven again. Found when every piece has a proven motion; its method is
// that of all pieces, or LazyPrm when they differ. Throws as plan() does, and InvalidOption for more than one motion.
MotionOutcome plan_pieces(const Unfolding& net, const MotionOptions& options = {}, const Run& run = {});

}  // namespace plico
