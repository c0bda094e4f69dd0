#include "plico/workflow/jobs/first_try.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/origami/pattern_check.h"

namespace plico::jobs {
namespace {

constexpr double kClosedGoal = 1e-6;    // radians: a vertex that closes
constexpr double kNearlyClosed = 0.02;  // radians: a goal that settling may close

std::string place_of(const CreasePattern& sheet, const VertexFacts& facts) {
  const Vec2& p = sheet.vertices[facts.vertex];
  return fmt::format("vertex {} at {:.6g} {:.6g}", facts.vertex, p.x(), p.y());
}

// Of a vertex that does not close: what the rules of flat folding say about it.
std::string broken_rule(const VertexFacts& facts) {
  const int folds = facts.mountains + facts.valleys;
  if (!facts.flat_folded)
    return fmt::format("its {} folds do not close by {:.3g} degrees", folds, degrees(facts.residual));
  if (folds % 2 == 1) return fmt::format("{} crease{} to fold flat, an odd number", folds, folds == 1 ? "" : "s");
  if (std::abs(facts.mountains - facts.valleys) != 2)
    return fmt::format("{} mountains and {} valleys to fold flat, they must differ by 2", facts.mountains,
                       facts.valleys);
  return fmt::format("every other sector misses 180 degrees by {:.3g}", degrees(facts.kawasaki));
}

}  // namespace

int num_unassigned(const CreasePattern& sheet) {
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  int count = 0;
  for (int e = 0; e < sheet.num_edges(); ++e)
    count += sheet.edges[e].assignment == Assignment::Unassigned && is_hinge(sheet.edges[e], sides[e]);
  return count;
}

std::string tell_what_stops(const CreasePattern& sheet, const MotionOutcome& outcome, const std::string& file) {
  if (const int free = num_unassigned(sheet); free > 0)
    return fmt::format(
        "stays flat: {} creases have no mountain or valley, so they have no goal; try plico origami "
        "assign {} -o assigned.fold",
        free, file);
  if (outcome.ending == Ending::TimedOut)
    return fmt::format("stays flat: the time was up before a motion was proven; try plico fold {} --time-limit 5m",
                       file);
  const std::vector<VertexFacts> vertices = vertex_facts(sheet);
  const auto worst = std::max_element(vertices.begin(), vertices.end(), [](const VertexFacts& a, const VertexFacts& b) {
    return a.residual < b.residual;
  });
  if (worst == vertices.end()) return fmt::format("stays flat; try plico origami info {} -v", file);
  const std::string place = place_of(sheet, *worst);
  if (worst->residual <= kClosedGoal)
    return fmt::format("stays flat: its goal closes, but no way leads out of flat; try plico fold {} --planner md-frog",
                       file);
  if (worst->residual <= kNearlyClosed)
    return fmt::format(
        "stays flat: its goal is open by {:.2g} rad, most at {}; try plico origami settle {} -o "
        "settled.fold",
        worst->residual, place, file);
  return fmt::format("stays flat: {}: {}; try plico origami info {} -v", place, broken_rule(*worst), file);
}

}  // namespace plico::jobs
