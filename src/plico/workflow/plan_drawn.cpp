#include "plico/workflow/plan_drawn.h"

#include <fmt/format.h>

#include "plico/origami/closure.h"
#include "plico/origami/settle.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr double kClosesWell = 1e-9;    // radians: a goal that needs no settling
constexpr double kSettlesBelow = 5e-3;  // radians: a goal open by more was not drawn to close
constexpr double kAllTheWay = 0.98;     // of it: then the drawing itself is not tried
constexpr double kGain = 0.01;          // of the way: what the settled sheet may be short by

double proven_share(const MotionOutcome& outcome) { return outcome.proven() ? outcome.progress : 0; }

std::string settled_note(const Settled& settled) {
  const std::string kept = settled.symmetries > 1 ? fmt::format(", {} symmetries kept", settled.symmetries) : "";
  return fmt::format(
      "settled: the goal was open by {:.2g} rad; vertices moved by at most {:.3g}, {:.2g} of the shortest edge{}",
      settled.open_before, settled.move, settled.move_share, kept);
}

}  // namespace

MotionOutcome plan_drawn(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  const std::vector<RealVertex> loops = real_vertices(sheet);
  const double open = closure(loops, goal(make_linkage(sheet))).worst;
  if (open <= kClosesWell || open > kSettlesBelow) return plan_origami(sheet, options, run);
  const Settled settled = settle(sheet, {.most_move = kSettledUnasked}, run);
  if (!settled.closed || run.over()) return plan_origami(sheet, options, run);
  MotionOutcome outcome = plan_origami(settled.sheet, options, run);
  if (!outcome.sheet) outcome.sheet = settled.sheet;
  outcome.notes.insert(outcome.notes.begin(), settled_note(settled));
  if (proven_share(outcome) >= kAllTheWay || run.over()) return outcome;
  MotionOutcome as_drawn = plan_origami(sheet, options, run);
  return proven_share(as_drawn) > proven_share(outcome) + kGain ? std::move(as_drawn) : std::move(outcome);
}

}  // namespace plico
