#include "plico/workflow/far_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "plico/base/rng.h"
#include "plico/origami/approach.h"
#include "plico/origami/closure.h"
#include "plico/origami/elastic_start.h"
#include "plico/origami/facets.h"
#include "plico/origami/orders.h"
#include "plico/verify/deformation.h"
#include "plico/verify/sheet_motion.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr double kOpening = 0.2;         // of the clearance, that hinges may open by between waypoints
constexpr double kRefineTime = 0.3;      // of what is left
constexpr long kMostLooks = 30'000'000;  // of a proof; about as many as fit in ten seconds
constexpr int kMostCuts = 6;             // of a path at its end, until the proof holds
constexpr double kWorthCutting = 0.01;   // of the way: what facets must gain
constexpr double kFarEnough = 0.98;      // of the way: then panels are not cut
constexpr double kNearFlat = 0.3;        // of the way: then creases may also turn against their goal on the way
constexpr double kPulledBelow = 0.8;     // of the way: then states are looked for that creases are pulled to
constexpr double kFewWays = 0.5;         // of the way: then pulled creases may also go to the other side
constexpr double kPulledTo[] = {0.1, 0.3, 0.6};
constexpr double kSearchTime = 0.5;         // of what is left: the rest is for the proof
constexpr double kFirstSearchTime = 0.7;    // of that, for a search that others follow
constexpr double kWholeTime = 0.4;          // of what is left, for whole panels when facets come next
constexpr int kMostCutLong = 600;           // creases and cuts: then other diagonals are tried too
constexpr int kMostCutDrawn = 400;          // the same: then drawn ones
constexpr int kDraws = 6, kMostDraws = 16;  // of diagonals
constexpr int kMostCutInAll = 640;     // creases and cuts of all draws together, where that allows more than the least
constexpr double kFirstCutTime = 0.5;  // of what is left, for the shortest diagonals when others come next
constexpr int kMostOrders = 96, kMostOrdersInAll = 60'000;  // draws, and creases of all of them together
constexpr int kPatience = 24;                               // draws without a gain that is worth a proof
constexpr double kOrdersTime = 0.8;                         // of what is left: the rest is for the last proof
constexpr double kWorthProving = 0.005, kLeastGain = 1e-4;  // of the way, at once and at the end
constexpr int kMostWaypoints = 1000;                        // beyond those of the way so far
constexpr std::uint64_t kOrders = 7;                        // stream of the seed
constexpr int kGoRounds = 8;                                // of panels that the proof met
constexpr double kCloses = 1e-9;                            // radians: of waypoints that are not open on purpose
constexpr double kOpenToBegin[] = {1.0, 0.25};              // radians over the deformation, by which loops may be open
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
  ElasticOptions elastic;
  elastic.may_turn_back = !approach.keep_sides;
  for (const double share : kPulledTo) {
    elastic.share = share;
    if (run.over()) return;
    const ContinuationResult begun = start_elastically(linkage, elastic, approach, run);
    if (begun.path.waypoints.size() < 2) continue;
    ContinuationResult far = approach_goal(linkage, begun.path, approach, run);
    if (far.progress > found.progress) found = std::move(far);
  }
}

// Without what follows the first step in which hinges may open by the clearance: that cannot be proven.
void cut_where_coarse(const Linkage& linkage, double clearance, FoldingPath& path) {
  const SheetMotion motion(linkage, path);
  const double most = clearance - motion.loops().tear;
  int steps = 0;
  while (steps + 1 < static_cast<int>(path.waypoints.size()) && motion.gap_after(steps) < most) ++steps;
  path.waypoints.resize(steps + 1);
  if (steps > 0) stretch_times(path);
}

// The motion up to the last waypoint that its proof came to. A proof looks at time from its beginning on, so it is a
// proof of that part.
Motion shown_part(const Linkage& linkage, const Motion& motion) {
  Motion part = motion;
  std::vector<Waypoint>& waypoints = part.path.waypoints;
  const auto first_beyond = std::find_if(waypoints.begin(), waypoints.end(),
                                         [&](const Waypoint& w) { return w.time > motion.proof.free_until; });
  waypoints.erase(first_beyond, waypoints.end());
  if (waypoints.size() < 2) return {motion.method, {}, motion.proof};
  stretch_times(part.path);
  part.proof.verdict = PathVerdict::Free;
  part.proof.interrupted = false;
  part.proof.from = part.proof.to = part.proof.depth = 0;
  part.proof.panel_a = part.proof.panel_b = -1;
  part.proof.free_until = 1;
  part.proof.loops = SheetMotion(linkage, part.path).loops();
  return part;
}

// Straight, then letting creases turn against their goal on the way, then from states that creases were pulled to.
// `hurried` becomes true where time ended one of these.
ContinuationResult search_far(const Linkage& linkage, const FoldingPath& begun, ApproachOptions approach, bool may_pull,
                              const Run& run, bool& hurried) {
  ContinuationResult found = approach_goal(linkage, begun, approach, share_of_time(run, kFirstSearchTime));
  hurried = found.ending == Ending::TimedOut;
  const ApproachOptions straight = approach;
  const bool starts_flat = begun.waypoints.size() < 2;
  if (starts_flat && found.ending != Ending::Found && found.progress < kNearFlat && !run.over()) {
    approach.keep_sides = false;
    ContinuationResult free = approach_goal(linkage, begun, approach, share_of_time(run, kFirstSearchTime));
    hurried = hurried || free.ending == Ending::TimedOut;
    if (free.progress > found.progress) found = std::move(free);
  }
  if (!may_pull || !starts_flat || found.progress > kPulledBelow) return found;
  start_otherwise(linkage, straight, run, found);
  if (found.progress < kFewWays) start_otherwise(linkage, approach, run, found);
  hurried = hurried || run.over();
  return found;
}

bool on_its_sides(const Linkage& linkage, const Configuration& config) {
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (config[h] * linkage.hinges[h].target < 0) return false;
  return true;
}

// What the proof found between two waypoints, the search did not see. So it goes on from a little before, and keeps
// these panels apart from there on.
void go_round(const Linkage& linkage, ApproachOptions approach, double clearance, const Run& run,
              std::vector<PanelPair>& met, ContinuationResult& found, Motion& motion) {
  const auto share = [&](const FoldingPath& path) {
    return path.waypoints.size() < 2 ? 0 : share_of_way(linkage, path.waypoints.back().config);
  };
  approach.keep_sides = on_its_sides(linkage, found.path.waypoints.back().config);
  for (int round = 0; round < kGoRounds && !met.empty() && !run.over(); ++round) {
    FoldingPath begun = motion.path;
    if (begun.waypoints.size() < 2) return;
    begun.waypoints.resize(std::max<std::size_t>(2, begun.waypoints.size() * 9 / 10));
    approach.watched.insert(approach.watched.end(), met.begin(), met.end());
    met.clear();
    ContinuationResult on = approach_goal(linkage, begun, approach, share_of_time(run, kSearchTime));
    Motion shown = prove_as_far(linkage, on.path, motion.method, clearance, run, &met);
    if (!(share(shown.path) > share(motion.path))) return;
    found = std::move(on);
    motion = std::move(shown);
  }
}

// What was found and proven, told.
FarMotion judged(const Linkage& linkage, const ContinuationResult& found, Motion motion) {
  FarMotion result;
  result.motion = std::move(motion);
  if (result.motion.path.waypoints.size() < 2 || result.motion.proof.verdict != PathVerdict::Free) {
    result.notes.push_back(why(linkage, found, result.motion));
    return result;
  }
  const Configuration& end = result.motion.path.waypoints.back().config;
  result.share = share_of_way(linkage, end);
  result.reached = found.ending == Ending::Found && end == found.path.waypoints.back().config;
  if (!result.reached)
    result.notes.push_back(fmt::format("{}; {}", why(linkage, found, result.motion), short_creases(linkage, end)));
  return result;
}

ApproachOptions approach_of(const Linkage& linkage, const MotionOptions& options) {
  ApproachOptions approach;
  approach.frames = options.waypoints;
  approach.collision.clearance = options.clearance > 0 ? options.clearance : default_clearance(linkage);
  return approach;
}

// A search that comes no farther than `least` is not worth its proof: then there is no motion.
FarMotion go_on(const Linkage& linkage, const FoldingPath& begun, const MotionOptions& options, bool may_pull,
                double least, const Run& run) {
  const ApproachOptions approach = approach_of(linkage, options);
  const double clearance = approach.collision.clearance;
  bool hurried = false;
  ContinuationResult found = search_far(linkage, begun, approach, may_pull, share_of_time(run, kSearchTime), hurried);
  Motion motion;
  if (found.path.waypoints.size() > 1 && found.progress > least) {
    std::vector<PanelPair> met;
    motion = prove_as_far(linkage, found.path, MotionMethod::Continuation, clearance, run, &met);
    go_round(linkage, approach, clearance, run, met, found, motion);
  }
  FarMotion result = judged(linkage, found, std::move(motion));
  result.timed_out = hurried || run.over() || found.ending == Ending::TimedOut;
  return result;
}

// Another way, proven as far as it goes; what of it is not is left off. The farther of both is `far`.
void prove_other(const Linkage& linkage, double clearance, const Run& run, ContinuationResult& way, FarMotion& far) {
  FarMotion proven = judged(linkage, way, prove_as_far(linkage, way.path, MotionMethod::Continuation, clearance, run));
  if (proven.share < way.progress) {
    way.path = proven.motion.path;
    way.progress = proven.share;
  }
  proven.timed_out = far.timed_out;
  if (proven.share > far.share) far = std::move(proven);
}

// From states on the way so far, with creases drawn to fold before others. In turns with a second way, which begins
// again where it stands still: what came farthest at first may be where no way goes on.
void go_in_other_orders(const Linkage& linkage, const MotionOptions& options, const Run& run, FarMotion& far) {
  if (far.motion.path.waypoints.size() < 2) return;
  ApproachOptions approach = approach_of(linkage, options);
  const double clearance = approach.collision.clearance;
  const int draws = std::min(kMostOrders, kMostOrdersInAll / std::max(1, linkage.num_hinges()));
  const Rng rng = Rng(options.seed).stream(kOrders);
  const Run searching = share_of_time(run, kOrdersTime);
  ContinuationResult ways[2];
  ways[0].path = far.motion.path;
  ways[0].progress = far.share;
  int last_gain = 0;  // of the second way
  for (int i = 0; i < draws && !far.reached && !searching.over(); ++i) {
    ContinuationResult& way = ways[i % 2];
    if (i % 2 == 1 && i - last_gain > kPatience) way = {}, last_gain = i;
    const std::size_t length = way.path.waypoints.size();
    approach.keep_sides = length < 2 || on_its_sides(linkage, way.path.waypoints.back().config);
    approach.max_waypoints = kMostWaypoints + static_cast<int>(length);
    ContinuationResult found =
        approach_in_drawn_order(linkage, way.path, approach, rng.stream(i), share_of_time(searching, kSearchTime));
    far.timed_out = far.timed_out || searching.over() || found.ending == Ending::TimedOut;
    if (found.path.waypoints.size() < 2 || found.progress <= way.progress) continue;
    if (i % 2 == 1 && found.progress >= way.progress + kWorthProving) last_gain = i;
    way = std::move(found);
    if (way.progress >= far.share + kWorthProving || way.ending == Ending::Found)
      prove_other(linkage, clearance, run, way, far);
  }
  for (ContinuationResult& way : ways)
    if (!far.reached && way.progress >= far.share + kLeastGain) prove_other(linkage, clearance, run, way, far);
}

// A sheet whose panels are cut, and its motion.
struct CutMotion {
  Facets facets;
  FarMotion far;
};

bool same_cuts(const Facets& a, const Facets& b) { return a.sheet.faces == b.sheet.faces; }

// The shortest diagonals first; where they do not lead to the goal the longest, and then some that are drawn: which of
// them open the way shows only when it is gone. The farthest of them.
CutMotion go_on_in_facets(const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  CutMotion best{cut_into_facets(sheet), {}};
  const Facets shortest = best.facets;
  const Linkage linkage = make_linkage(shortest.sheet);
  const int creases = linkage.num_hinges();
  const int draws = std::clamp(kMostCutInAll / std::max(1, creases), kDraws, kMostDraws);
  const int tries = creases > kMostCutLong ? 0 : creases > kMostCutDrawn ? 1 : 1 + draws;
  best.far = go_on(linkage, {}, options, true, 0, tries > 0 ? share_of_time(run, kFirstCutTime) : run);
  for (int i = 0; i < tries && best.far.share < kFarEnough && !run.over(); ++i) {
    Facets other = cut_into_facets(sheet, i == 0 ? CutChoice::Long : CutChoice::Drawn, options.seed + i);
    if (same_cuts(other, shortest)) continue;
    const double least = best.far.share + kWorthCutting;
    FarMotion found = go_on(make_linkage(other.sheet), {}, options, true, least, share_of_time(run, 1.0 / (tries - i)));
    found.timed_out = best.far.timed_out = best.far.timed_out || found.timed_out;
    if (found.share > least) best = {std::move(other), std::move(found)};
  }
  return best;
}

// In other orders as well, with what to tell of its panels.
FarMotion finish_cut(CutMotion cut, const CreasePattern& sheet, const MotionOptions& options, const Run& run) {
  if (cut.far.share < kFarEnough) go_in_other_orders(make_linkage(cut.facets.sheet), options, run, cut.far);
  if (cut.far.motion.path.waypoints.empty()) return std::move(cut.far);
  cut.far.bends = bends_of(cut.facets, sheet.num_faces(), cut.far.motion.path);
  cut.far.notes.push_back(bends_note(cut.far.bends));
  cut.far.sheet = std::move(cut.facets.sheet);
  return std::move(cut.far);
}

// Without what follows the first waypoint that is deformed more than allowed.
void cut_where_deformed(const CreasePattern& sheet, const Linkage& linkage, double most, FoldingPath& path) {
  std::vector<Waypoint>& waypoints = path.waypoints;
  const auto beyond = std::find_if(waypoints.begin(), waypoints.end(), [&](const Waypoint& w) {
    return tear(sheet, linkage, w.config).deformation > most;
  });
  waypoints.erase(beyond, waypoints.end());
  if (waypoints.size() > 1) stretch_times(path);
}

// As go_on, with loops open by up to `open` radians.
FarMotion go_open(const Linkage& linkage, const CreasePattern& sheet, const MotionOptions& options, double open,
                  const Run& run) {
  const double exact = options.clearance > 0 ? options.clearance : default_clearance(linkage);
  const double clearance = deformed_clearance(exact, options.deformation);
  const double widest = (clearance - exact) / diagonal(sheet);
  ApproachOptions approach;
  approach.frames = options.waypoints;
  approach.collision.clearance = clearance;
  approach.tolerance = open;
  approach.damping = std::max(approach.damping, open / 100);
  approach.accepts = [&](const Configuration& config) {
    const Tear torn = tear(sheet, linkage, config);
    return torn.gap <= widest && torn.deformation <= options.deformation;
  };
  ContinuationResult found = approach_goal(linkage, {}, approach, share_of_time(run, kSearchTime));
  Motion motion;
  if (found.path.waypoints.size() > 1) {
    motion = prove_as_far(linkage, found.path, MotionMethod::Continuation, clearance, run, nullptr, open);
    const std::size_t before = motion.path.waypoints.size();
    cut_where_deformed(sheet, linkage, options.deformation, motion.path);
    if (motion.path.waypoints.size() < before && motion.path.waypoints.size() > 1)
      motion = prove_as_far(linkage, motion.path, MotionMethod::Continuation, clearance, run, nullptr, open);
  }
  if (motion.proof.verdict != PathVerdict::Free) motion.path.waypoints.clear();
  FarMotion result = judged(linkage, found, std::move(motion));
  result.timed_out = run.over() || found.ending == Ending::TimedOut;
  return result;
}

// Whole, or cut by flat creases where that leads farther.
FarMotion go_with_panels(const Linkage& linkage, const CreasePattern* sheet, const FoldingPath& begun,
                         const MotionOptions& options, const Run& run) {
  const bool may_cut = sheet && options.facets != FacetPolicy::None;
  if (may_cut && options.facets == FacetPolicy::All)
    return finish_cut(go_on_in_facets(*sheet, options, run), *sheet, options, run);
  // Whole panels that are locked will be cut; pulling them first is time lost.
  const bool will_cut =
      may_cut && std::any_of(sheet->faces.begin(), sheet->faces.end(), [](const auto& f) { return f.size() > 3; });
  FarMotion whole = go_on(linkage, begun, options, !will_cut, 0, will_cut ? share_of_time(run, kWholeTime) : run);
  if (whole.share >= kFarEnough) return whole;
  if (will_cut && !run.over()) {
    CutMotion cut = go_on_in_facets(*sheet, options, run);
    cut.far.timed_out = whole.timed_out = cut.far.timed_out || whole.timed_out;
    if (cut.far.share > whole.share + kWorthCutting) return finish_cut(std::move(cut), *sheet, options, run);
  }
  go_in_other_orders(linkage, options, run, whole);
  return whole;
}

}  // namespace

Run share_of_time(const Run& run, double share) {
  if (!run.deadline) return run;
  const double left = std::chrono::duration<double>(*run.deadline - Run::Clock::now()).count();
  return limited(run, share * std::max(0.0, left));
}

Motion prove_as_far(const Linkage& linkage, const FoldingPath& planned, MotionMethod method, double clearance,
                    const Run& run, std::vector<PanelPair>* met, double open) {
  Motion motion{method, planned, {}};
  stretch_times(motion.path);
  const double gap = kOpening * (open > 0 ? std::min(clearance, default_clearance(linkage)) : clearance);
  motion.path = refine_path(linkage, motion.path, gap, share_of_time(run, kRefineTime), std::max(kCloses, open));
  cut_where_coarse(linkage, clearance, motion.path);
  PathProofOptions proof{.clearance = clearance, .max_looks = kMostLooks};
  if (open > 0) proof.closing = kOpenOnPurpose;
  Motion shown;
  for (int cuts = 0; cuts <= kMostCuts && motion.path.waypoints.size() > 1; ++cuts) {
    motion.proof = prove_path(linkage, motion.path, proof, run);
    if (motion.proof.verdict == PathVerdict::Free) return motion;
    if (met && motion.proof.panel_a >= 0)
      met->push_back(
          {std::min(motion.proof.panel_a, motion.proof.panel_b), std::max(motion.proof.panel_a, motion.proof.panel_b)});
    Motion part = shown_part(linkage, motion);
    // Proven once more by itself, as a judge will who sees no more than this part.
    motion.path = part.path;
    if (part.path.waypoints.size() > shown.path.waypoints.size()) shown = std::move(part);
    if (run.over()) break;
  }
  return shown;
}

FarMotion go_deformed(const Linkage& linkage, const CreasePattern& sheet, const MotionOptions& options,
                      const Run& run) {
  FarMotion best;
  const int tries = static_cast<int>(std::size(kOpenToBegin));
  for (int i = 0; i < tries && !best.reached && !run.over(); ++i) {
    const double open = kOpenToBegin[i] * options.deformation;
    FarMotion far = go_open(linkage, sheet, options, open, share_of_time(run, 1.0 / (tries - i)));
    if (i == 0 || far.share > best.share) best = std::move(far);
  }
  return best;
}

FarMotion go_as_far(const Linkage& linkage, const CreasePattern* sheet, const FoldingPath& begun,
                    const MotionOptions& options, const Run& run) {
  FarMotion far = go_with_panels(linkage, sheet, begun, options, run);
  if (far.timed_out && !far.reached && far.motion.path.waypoints.size() > 1)
    far.notes.emplace_back("the time limit cut the search short: more time may lead farther");
  return far;
}

}  // namespace plico
