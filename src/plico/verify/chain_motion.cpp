#include "plico/verify/chain_motion.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/geom/oriented_box.h"
#include "plico/verify/panel_motion.h"

namespace plico {
namespace {

constexpr double kSameAngle = 1e-9;  // radians
constexpr double kShortest = 1e-10;  // of a segment: a shorter step forward decides nothing
constexpr double kSamePlace = 1e-9;  // of a side

// A panel, or a pile of them, where it is at the start of a segment.
struct Block {
  int group = 0;
  int first = 0, last = 0;  // panels
  OrientedBox box;
  double radius = 0;
};

// One segment of the path: what moves, and the blocks that rest in themselves.
class Segment {
 public:
  Segment(const Linkage& chain, const Configuration& from, const Configuration& to, double air)
      : chain_(chain), from_(from), to_(to), air_(air * chain.thickness), start_(folding_map(chain, from)) {
    for (int h = 0; h < chain.num_hinges(); ++h)
      if (from[h] != to[h]) moving_.push_back(h);
    int first = 0;
    for (std::size_t m = 0; m <= moving_.size(); ++m) {
      const int last = m < moving_.size() ? moving_[m] : chain.num_panels() - 1;
      add_group(static_cast<int>(m), first, last);
      first = last + 1;
    }
  }

  const std::vector<Block>& blocks() const { return blocks_; }
  int num_moving() const { return static_cast<int>(moving_.size()); }

  bool are_mates(const Block& a, const Block& b) const {
    return b.group == a.group + 1 && a.first == a.last && b.first == b.last && a.last == moving_[a.group] &&
           b.first == a.last + 1;
  }

  // Most speed of a point of `b` as the group of `a` sees it, lengths per segment. Arms run from axis to axis through
  // rigid groups, so they keep their length but for the change of axes of a thick hinge.
  double speed(const Block& a, const Block& b) const {
    double arm = 0, sum = 0;
    Vec3 at = b.box.center;
    for (int m = b.group - 1; m >= a.group; --m) {
      const Hinge& hinge = chain_.hinges[moving_[m]];
      const Vec3 axis_point = start_[moving_[m]] * Vec3((hinge.from + hinge.to) / 2);
      arm += (at - axis_point).norm() + 2 * std::sqrt(2.0) * hinge.roll + (m == b.group - 1 ? b.radius : 0);
      sum += std::abs(to_[moving_[m]] - from_[moving_[m]]) * arm;
      at = axis_point;
    }
    return sum;
  }

  // The motion of b's group, as a's group sees it, from the start of the segment to `time` in [0, 1].
  Pose moved(const Block& a, const Block& b, double time) const {
    const int first = moving_[a.group];  // the panel that holds the first of the hinges
    Pose now = start_[first];
    for (int m = a.group; m < b.group; ++m) {
      const int h = moving_[m];
      // From the panel before this hinge to the one before the next: rest in between, as at the start.
      if (m > a.group) now = now * (start_[moving_[m - 1] + 1].inverse(Eigen::Isometry) * start_[h]);
      const double angle = from_[h] + time * (to_[h] - from_[h]);
      now = now * turn(chain_.hinges[h], angle, chain_.hinges[h].right == h + 1);
    }
    return now * start_[moving_[b.group - 1] + 1].inverse(Eigen::Isometry);
  }

 private:
  // The panels beside a moving hinge stand alone: they are mates across it.
  void add_group(int group, int first, int last) {
    for (int p = first; p <= last;) {
      int end = p;
      const bool alone = (p == first && group > 0) || (p == last && group < num_moving());
      while (!alone && end < last && !(end + 1 == last && group < num_moving()) && is_piled(p, end + 1)) ++end;
      add_block(group, p, end);
      p = end + 1;
    }
  }

  // Does panel `next` lie in the pile that begins with `first`: straight above or below it?
  bool is_piled(int first, int next) const {
    if (std::abs(std::abs(from_[next - 1]) - kPi) > kSameAngle) return false;
    const Pose seen = start_[first].inverse(Eigen::Isometry) * start_[next];
    const Vec3 off = seen * middle(next) - middle(first);
    return off.head<2>().norm() < kSamePlace * side() && std::abs(std::abs(seen.linear()(2, 2)) - 1) < kSamePlace;
  }

  Vec3 middle(int panel) const { return (chain_.panels[panel][0] + chain_.panels[panel][2]) / 2; }
  double side() const { return (chain_.panels[0][1] - chain_.panels[0][0]).norm(); }

  void add_block(int group, int first, int last) {
    Block block;
    block.group = group;
    block.first = first;
    block.last = last;
    const Pose back = start_[first].inverse(Eigen::Isometry);
    double low = 0, high = 0;
    for (int p = first; p <= last; ++p) {
      const double z = (back * (start_[p] * middle(p))).z();
      low = std::min(low, z);
      high = std::max(high, z);
    }
    low -= chain_.thickness / 2 - air_;
    high += chain_.thickness / 2 - air_;
    const OrientedBox flat{middle(first) + (low + high) / 2 * Vec3::UnitZ(),
                           Eigen::Matrix3d::Identity(),
                           {side() / 2, side() / 2, (high - low) / 2}};
    block.box = placed(flat, start_[first]);
    block.radius = flat.half.norm();
    blocks_.push_back(block);
  }

  const Linkage& chain_;
  const Configuration &from_, &to_;
  const double air_;
  const std::vector<Pose> start_;
  std::vector<int> moving_;
  std::vector<Block> blocks_;
};

class ChainJudge {
 public:
  ChainJudge(const Linkage& chain, const FoldingPath& path, const ChainMotionOptions& options, const Run& run,
             ChainMotionVerdict& verdict)
      : chain_(chain), path_(path), options_(options), run_(run), verdict_(verdict) {}

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
    const Segment segment(chain_, from.config, to.config, options_.air);
    for (const Block& b : segment.blocks()) {
      if (b.group == 0) continue;
      for (const Block& a : segment.blocks()) {
        if (a.group >= b.group) break;
        if (segment.are_mates(a, b)) continue;
        const double at = advance(segment, a, b);
        if (at >= 1) continue;
        verdict_.from = verdict_.to = from.time + at * (to.time - from.time);
        verdict_.panel_a = a.first;
        verdict_.panel_b = b.first;
        return false;
      }
    }
    return true;
  }

  // Until when the blocks are apart, 1 for the whole segment.
  double advance(const Segment& segment, const Block& a, const Block& b) {
    const double speed = segment.speed(a, b);
    for (double time = 0;;) {
      const OrientedBox there = placed(b.box, segment.moved(a, b, time));
      ++verdict_.steps;
      double apart = distance(there, a.box.center) - a.radius;  // at most the distance, and quickly told
      if (apart < (1 - time) * speed && apart < a.radius) apart = gap(a.box, there);
      if (apart > (1 - time) * speed || (time >= 1 && apart > 0)) return 1;
      const double step = std::max(0.0, apart) / speed;
      if (step < kShortest) return contact(segment, a, b, time);
      time = std::min(1.0, time + step);
    }
  }

  // The blocks all but touch at `time`, where steps forward get ever shorter: do they meet soon after?
  double contact(const Segment& segment, const Block& a, const Block& b, double time) {
    for (double ahead = kShortest; time + ahead <= 1; ahead *= 2) {
      if (gap(a.box, placed(b.box, segment.moved(a, b, time + ahead))) >= 0) continue;
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
