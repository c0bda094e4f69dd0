#include "plico/workflow/plan_drawn.h"

#include <fmt/format.h>

#include <cmath>

#include "plico/base/error.h"
#include "plico/origami/closure.h"
#include "plico/origami/pattern_check.h"
#include "plico/origami/settle.h"
#include "plico/verify/deformation.h"
#include "plico/workflow/far_motion.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr double kClosesWell = 1e-9;    // radians: a goal that needs no settling
constexpr double kSettlesBelow = 5e-3;  // radians: a goal open by more was not drawn to close
constexpr double kAllTheWay = 0.98;     // of it: then the drawing itself is not tried
constexpr double kGain = 0.01;          // of the way: what the settled sheet may be short by
constexpr double kExactTime = 0.5;      // of what is left, before sheets may be deformed

double proven_share(const MotionOutcome& outcome) { return outcome.proven() ? outcome.progress : 0; }

std::string settled_note(const Settled& settled) {
  const std::string kept = settled.symmetries > 1 ? fmt::format(", {} symmetries kept", settled.symmetries) : "";
  return fmt::format(
      "settled: the goal was open by {:.2g} rad; vertices moved by at most {:.3g}, {:.2g} of the shortest edge{}",
      settled.open_before, settled.move, settled.move_share, kept);
}

MotionOutcome plan_exact(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
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

MotionOutcome deformed(const CreasePattern& sheet, const Linkage& linkage, const MotionOptions& options,
                       const Run& run) {
  FarMotion far = go_deformed(linkage, sheet, options, run);
  MotionOutcome outcome;
  outcome.notes = std::move(far.notes);
  outcome.progress = far.share;
  outcome.ending = far.reached ? Ending::Found : far.timed_out ? Ending::TimedOut : Ending::Exhausted;
  if (far.motion.path.waypoints.size() < 2) return outcome;
  const Deformation measured = measure_deformation(sheet, linkage, far.motion.path);
  outcome.deformation = measured.worst;
  outcome.notes.insert(
      outcome.notes.begin(),
      fmt::format(
          "deformed: edges change their length by up to {:.2g} %, {:.3g} % allowed, edge {} the most; loops are "
          "open by up to {:.2g} units",
          100 * measured.worst, 100 * options.deformation, measured.edge, far.motion.proof.loops.tear));
  outcome.motions.push_back(std::move(far.motion));
  return outcome;
}

MotionOutcome plan_as_allowed(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  const Linkage linkage = make_linkage(sheet);
  if (options.deformation == 0 || !linkage.has_loops()) return plan_exact(sheet, options, run);
  require(options.deformation > 0 && options.deformation <= kMostDeformation, "deformation", options.deformation,
          fmt::format("in [0, {}]", kMostDeformation));
  MotionOutcome exact = plan_exact(sheet, options, share_of_time(run, kExactTime));
  if (proven_share(exact) >= 1 || run.over()) return exact;
  MotionOutcome open = deformed(sheet, linkage, options, run);
  return proven_share(open) > proven_share(exact) + kGain ? std::move(open) : std::move(exact);
}

// Around a vertex that is folded flat mountains and valleys differ by two, or its layers pass through each other.
std::string crossing_note(const CreasePattern& sheet) {
  int count = 0;
  std::string first;
  for (const VertexFacts& vertex : vertex_facts(sheet)) {
    const int folds = vertex.mountains + vertex.valleys;
    if (!vertex.flat_folded || folds % 2 == 1 || std::abs(vertex.mountains - vertex.valleys) == 2) continue;
    if (count++ == 0)
      first = fmt::format("vertex {} has {} mountains and {} valleys of 180 degrees, which must differ by 2",
                          vertex.vertex, vertex.mountains, vertex.valleys);
  }
  if (count == 0) return {};
  const std::string more = count > 1 ? fmt::format("; {} more do not", count - 1) : "";
  return fmt::format("at the goal paper passes through paper: {} (Maekawa){}", first, more);
}

}  // namespace

MotionOutcome plan_drawn(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  MotionOutcome outcome = plan_as_allowed(sheet, options, run);
  if (proven_share(outcome) < 1)
    if (const std::string note = crossing_note(sheet); !note.empty()) outcome.notes.push_back(note);
  return outcome;
}

}  // namespace plico
