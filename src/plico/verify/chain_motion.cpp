#include "plico/verify/chain_motion.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/verify/chain_approach.h"
#include "plico/verify/panel_motion.h"

namespace plico {
namespace {

constexpr double kSameAngle = 1e-9;  // radians
constexpr double kShortest = 1e-10;  // of a segment: a shorter step forward decides nothing

class ChainJudge {
 public:
  ChainJudge(const Linkage& chain, const FoldingPath& path, const ChainMotionOptions& options, const Run& run,
             ChainMotionVerdict& verdict)
      : chain_(chain), path_(path), options_(options), run_(run), verdict_(verdict), poses_(chain) {}

  void run() {
    for (std::size_t i = 0; i + 1 < path_.waypoints.size(); ++i) {
      const Waypoint &a = path_.waypoints[i], &b = path_.waypoints[i + 1];
      if (run_.over()) {
        verdict_.interrupted = true;
        verdict_.from = a.time;
        verdict_.to = 1;
        return;
      }
      run_.report("proving the motion", static_cast<long>(i), static_cast<long>(path_.waypoints.size()) - 1);
      if (!is_free(a, b)) return;
    }
    verdict_.verdict = PathVerdict::Free;
  }

 private:
  bool is_free(const Waypoint& from, const Waypoint& to) {
    poses_.fold(from.config);
    const ChainSegment segment(chain_, poses_.all(), from.config, to.config, options_.air);
    for (const ChainBlock& b : segment.blocks())
      for (int group = 0; group < b.group; ++group) {
        const double at = meet(ChainApproach(segment, group, b), 0, 0, b.box);
        if (at >= 1) continue;
        verdict_.from = verdict_.to = from.time + at * (to.time - from.time);
        verdict_.panel_b = b.first;
        return false;
      }
    return true;
  }

  // Until when the block is apart from all that the sphere holds, 1 for the whole segment; `there` is where it is at
  // `time`, until when it is known to be. A sphere that comes near gives way to the two in it, at that time.
  double meet(const ChainApproach& way, std::size_t node, double time, OrientedBox there) {
    const ChainSegment::Sphere& sphere = way.segment().spheres(way.seen_by())[node];
    for (;;) {
      ++verdict_.steps;
      const double apart = distance(there, sphere.center) - sphere.radius;
      if (apart > (1 - time) * way.speed()) return 1;
      if (apart < sphere.radius) break;
      time += apart / way.speed();
      there = way.at(time);
    }
    if (sphere.is_leaf()) return meet_block(way, way.segment().blocks()[sphere.first], time, there);
    const double met = meet(way, sphere.left, time, there);
    return met < 1 ? met : meet(way, sphere.left + 1, time, there);
  }

  double meet_block(const ChainApproach& way, const ChainBlock& a, double time, OrientedBox there) {
    if (way.segment().are_mates(a, way.block())) return 1;
    for (;;) {
      ++verdict_.steps;
      const double apart = gap(a.box, there);
      if (apart > (1 - time) * way.speed() || (time >= 1 && apart > 0)) return 1;
      const double until = apart > 0 ? way.apart_until(a.box, time) : time;
      if (until - time < kShortest && until < way.next_change(time)) {
        verdict_.panel_a = a.first;
        return contact(way, a, time);
      }
      time = until;
      there = way.at(time);
    }
  }

  // The blocks all but touch at `time`, where steps forward get ever shorter: do they meet soon after?
  double contact(const ChainApproach& way, const ChainBlock& a, double time) {
    for (double ahead = kShortest; time + ahead <= 1; ahead *= 2) {
      if (gap(a.box, way.at(time + ahead)) >= 0) continue;
      verdict_.verdict = PathVerdict::Collides;
      return time + ahead;
    }
    return time;
  }

  const Linkage& chain_;
  const FoldingPath& path_;
  const ChainMotionOptions& options_;
  const Run& run_;
  ChainMotionVerdict& verdict_;
  ChainPoses poses_;
};

void check_ends(const ChainClaim& claim, const Linkage& chain, const FoldingPath& path, ChainMotionVerdict& verdict) {
  const Configuration &first = path.waypoints.front().config, &last = path.waypoints.back().config;
  for (int h = 0; h < chain.num_hinges(); ++h)
    if (std::abs(first[h] - claim.stack[h]) > kSameAngle) {
      verdict.defects.push_back(
          {"motion/start", fmt::format("the motion begins with hinge {} at {:.3g} degrees, the stack "
                                       "has it at {:.3g}",
                                       h, degrees(first[h]), degrees(claim.stack[h]))});
      break;
    }
  for (const Waypoint& waypoint : path.waypoints)
    for (int h = 0; h < chain.num_hinges(); ++h)
      if (std::abs(waypoint.config[h]) > kPi + kSameAngle) {
        verdict.defects.push_back({"motion/limit", fmt::format("hinge {} turns to {:.4g} degrees at time {:.4g}", h,
                                                               degrees(waypoint.config[h]), waypoint.time)});
        return;
      }
  while (verdict.opened < chain.num_hinges() &&
         std::abs(last[verdict.opened] - chain.hinges[verdict.opened].target) <= kSameAngle)
    ++verdict.opened;
  const int claimed = claim.opened >= 0 ? claim.opened : chain.num_hinges();
  if (verdict.opened != claimed)
    verdict.defects.push_back(
        {"motion/end", fmt::format("the motion brings {} of {} hinges into the shape, {} are claimed", verdict.opened,
                                   chain.num_hinges(), claimed)});
}

}  // namespace

ChainMotionVerdict judge_chain_motion(const ChainClaim& claim, const FoldingPath& path,
                                      const ChainMotionOptions& options, const Run& run) {
  const Linkage chain = chain_linkage_of(claim);
  ChainMotionVerdict verdict = judge_chain_motion(chain, path, options, run);
  check_ends(claim, chain, path, verdict);
  return verdict;
}

ChainMotionVerdict judge_chain_motion(const Linkage& chain, const FoldingPath& path, const ChainMotionOptions& options,
                                      const Run& run) {
  require(options.air > 0 && options.air < 0.5, "air", options.air, "in (0, 0.5)");
  check_path(chain, path);
  ChainMotionVerdict verdict;
  ChainJudge(chain, path, options, run, verdict).run();
  return verdict;
}

}  // namespace plico
