#include "plico/workflow/far_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "plico/origami/approach.h"
#include "plico/origami/elastic_start.h"
#include "plico/origami/facets.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr double kOpening = 0.2;        // of the clearance, that hinges may open by between waypoints
constexpr int kMostCuts = 6;            // of a path at its end, until the proof holds
constexpr double kWorthCutting = 0.01;  // of the way: what facets must gain
constexpr double kFarEnough = 0.98;     // of the way: then panels are not cut
constexpr double kNearFlat = 0.3;       // of the way: then creases may also turn against their goal on the way
constexpr double kPulledTo[] = {0.1, 0.3, 0.6};
constexpr double kShareOfTime = 0.45;  // that is left, for the first proof
constexpr double kShort = radians(0.5);
constexpr double kBends = 1e-9;  // radians
constexpr int kMostNamed = 3;

void stretch_times(FoldingPath& path) {
  const double last = path.waypoints.back().time;
  for (Waypoint& w : path.waypoints) w.time /= last;
  path.waypoints.back().time = 1;
}

std::string why(const Linkage& linkage, const ContinuationResult& found, const Motion& motion) {
  const bool cut_short = !motion.path.waypoints.empty() && motion.proof.verdict == PathVerdict::Free &&
                         motion.path.waypoints.back().config != found.path.waypoints.back().config;
  if (cut_short) return "the rest of the way cannot be proven free of collision";
  switch (found.obstacle) {
    case Obstacle::Collision:
      return fmt::format("panels {} and {} would collide", found.panels.a, found.panels.b);
    case Obstacle::GoalOpen:
      return fmt::format("this is the closed state nearest to a goal that opens {} by {:.3g} rad",
                         tell_vertex(linkage, found.vertex), found.residual);
    case Obstacle::Locked:
    case Obstacle::WrongSide:
      return fmt::format("locked; going straight on opens {} by {:.3g} rad", tell_vertex(linkage, found.vertex),
                         found.residual);
    case Obstacle::None:
      break;
  }
  return found.ending == Ending::Found ? "the goal" : "the search ended";
}

// "12 of 40 creases are short of their goal, crease 7 (vertices 3-9) by 31.2 degrees".
std::string short_creases(const Linkage& linkage, const Configuration& end) {
  std::vector<std::pair<double, int>> missing;
  int driven = 0;
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    if (linkage.hinges[h].target == 0) continue;
    ++driven;
    const double off = std::abs(linkage.hinges[h].target - end[h]);
    if (off > kShort) missing.emplace_back(-off, h);
  }
  std::sort(missing.begin(), missing.end());
  std::string named;
  for (std::size_t i = 0; i < missing.size() && i < kMostNamed; ++i) {
    const auto [off, h] = missing[i];
    const Hinge& hinge = linkage.hinges[h];
    named += fmt::format("{} crease {} (vertices {}-{}) by {:.3g}", i ? "," : ":", hinge.edge, hinge.a, hinge.b,
                         degrees(-off));
  }
  return fmt::format("{} of {} creases are short of their goal, in degrees{}{}", missing.size(), driven, named,
                     missing.size() > kMostNamed ? ", ..." : "");
}

// The panels that their cuts let bend.
std::vector<double> bends_of(const Facets& facets, int num_panels, const FoldingPath& path) {
  std::vector<double> bends(num_panels, 0);
  const std::vector<int> hinge = hinge_of_edge(facets.sheet);
  const std::vector<EdgeSides> sides = edge_sides(facets.sheet);
  for (int e = facets.first_cut; e < facets.sheet.num_edges(); ++e) {
    if (hinge[e] < 0) continue;
    double& bend = bends[facets.panel[sides[e].left]];
    for (const Waypoint& w : path.waypoints) {
      const double angle = std::abs(w.config[hinge[e]]);
      if (angle > kBends) bend = std::max(bend, angle);
    }
  }
  return bends;
}

std::string bends_note(const std::vector<double>& bends) {
  const auto most = std::max_element(bends.begin(), bends.end());
  const auto count = std::count_if(bends.begin(), bends.end(), [](double bend) { return bend > 0; });
  if (count == 0) return "panels were cut by flat creases, and none of them bends";
  return fmt::format("cut by flat creases, {} of {} panels bend, panel {} the most, by up to {:.3g} degrees", count,
                     bends.size(), most - bends.begin(), degrees(*most));
}

// Where no first step out of flat leads far, states pulled to shares of the goal may.
void start_otherwise(const Linkage& linkage, const ApproachOptions& approach, const Run& run,
                     ContinuationResult& found) {
  for (const double share : kPulledTo) {
    if (run.over()) return;
    const ContinuationResult begun = start_elastically(linkage, {.share = share}, approach, run);
    if (begun.path.waypoints.size() < 2) continue;
    ContinuationResult far = approach_goal(linkage, begun.path, approach, run);
    if (far.progress > found.progress + kWorthCutting) found = std::move(far);
  }
}

// A proof that a time limit ends has shown the beginning of the motion, which is proven again once the rest is cut off.
Run leaving_time_to_cut(const Run& run) {
  if (!run.deadline) return run;
  const double left = std::chrono::duration<double>(*run.deadline - Run::Clock::now()).count();
  return limited(run, kShareOfTime * std::max(0.0, left));
}

FarMotion go_on(const Linkage& linkage, const FoldingPath& begun, const MotionOptions& options, bool may_pull,
                const Run& run) {
  const double clearance = options.clearance > 0 ? options.clearance : default_clearance(linkage);
  ApproachOptions approach;
  approach.frames = options.waypoints;
  approach.collision.clearance = clearance;
  ContinuationResult found = approach_goal(linkage, begun, approach, run);
  const bool starts_flat = begun.waypoints.size() < 2;
  if (starts_flat && found.ending != Ending::Found && found.progress < kNearFlat && !run.over()) {
    approach.keep_sides = false;
    ContinuationResult free = approach_goal(linkage, begun, approach, run);
    if (free.progress > found.progress) found = std::move(free);
  }
  if (may_pull && starts_flat && found.progress < kNearFlat) start_otherwise(linkage, approach, run, found);
  FarMotion result;
  if (found.path.waypoints.size() > 1)
    result.motion = prove_as_far(linkage, found.path, MotionMethod::Continuation, clearance, run);
  if (result.motion.path.waypoints.size() > 1 && result.motion.proof.verdict == PathVerdict::Free) {
    const Configuration& end = result.motion.path.waypoints.back().config;
    result.share = share_of_way(linkage, end);
    result.reached = found.ending == Ending::Found && end == found.path.waypoints.back().config;
    if (result.reached) return result;
    result.notes.push_back(fmt::format("{}; {}", why(linkage, found, result.motion), short_creases(linkage, end)));
  } else {
    result.notes.push_back(why(linkage, found, result.motion));
  }
  return result;
}

FarMotion go_on_in_facets(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  const Facets facets = cut_into_facets(sheet);
  FarMotion result = go_on(make_linkage(facets.sheet), {}, options, true, run);
  if (result.motion.path.waypoints.empty()) return result;
  result.bends = bends_of(facets, sheet.num_faces(), result.motion.path);
  result.notes.push_back(bends_note(result.bends));
  result.sheet = facets.sheet;
  return result;
}

}  // namespace

Motion prove_as_far(const Linkage& linkage, const FoldingPath& planned, MotionMethod method, double clearance,
                    const Run& run) {
  Motion motion{method, planned, {}};
  stretch_times(motion.path);
  motion.path = refine_path(linkage, motion.path, kOpening * clearance, run);
  std::vector<Waypoint>& waypoints = motion.path.waypoints;
  for (int cuts = 0; cuts <= kMostCuts; ++cuts) {
    motion.proof =
        prove_path(linkage, motion.path, {.clearance = clearance}, cuts == 0 ? leaving_time_to_cut(run) : run);
    if (motion.proof.verdict == PathVerdict::Free || run.over()) return motion;
    const double proven = motion.proof.from;
    const auto first_beyond =
        std::find_if(waypoints.begin(), waypoints.end(), [&](const Waypoint& w) { return w.time > proven; });
    const bool all_kept_is_proven = cuts == 0 || motion.proof.interrupted;
    const auto last_kept = first_beyond - waypoints.begin() - 1 - (all_kept_is_proven ? 0 : 1 << cuts);
    if (last_kept < 1) break;
    waypoints.resize(last_kept + 1);
    stretch_times(motion.path);
  }
  return motion;
}

FarMotion go_as_far(const Linkage& linkage, const CreasePattern* sheet, const FoldingPath& begun,
                    const MotionOptions& options, const Run& run) {
  const bool may_cut = sheet && options.facets != FacetPolicy::None;
  if (may_cut && options.facets == FacetPolicy::All) return go_on_in_facets(*sheet, options, run);
  // Whole panels that are locked will be cut; pulling them first is time lost.
  const bool will_cut =
      may_cut && std::any_of(sheet->faces.begin(), sheet->faces.end(), [](const auto& f) { return f.size() > 3; });
  FarMotion whole = go_on(linkage, begun, options, !will_cut, run);
  if (!may_cut || whole.share >= kFarEnough || run.over()) return whole;
  FarMotion cut = go_on_in_facets(*sheet, options, run);
  return cut.share > whole.share + kWorthCutting ? cut : whole;
}

}  // namespace plico
