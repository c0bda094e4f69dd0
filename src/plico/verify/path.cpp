#include "plico/verify/path.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "plico/base/error.h"
#include "plico/verify/proof_plates.h"
#include "plico/verify/separation.h"

namespace plico {
namespace {

// Pairs that the boxes may leave over before an interval is halved instead. Boxes of long thin panels never come apart:
// the more halvings were of no use, the more pairs are looked at one by one.
constexpr std::size_t kPairsPerPlateAndHalving = 2;
constexpr int kMaxBulkHalvings = 12;  // time intervals of 1/4096 are short enough to look at pairs one by one

struct PlatePair {
  int a, b;        // plates
  int frame;       // panel from which they are looked at, -1: the world
  Vec3 direction;  // in that frame: separated the pair when last looked at
};

struct PlateBox {
  Eigen::AlignedBox3d box;
  int plate = -1;
};

// The side from which a pair came to touch, and until when it has.
struct Contact {
  double until;
  Vec3 direction;
};

// Pairs of plates known to be apart for a while. Time only moves on, and what is known of a pair ends before more is.
class KnownApart {
 public:
  explicit KnownApart(std::size_t num_plates) : known_(num_plates), row_(num_plates, -1) {}

  void set(int a, int b, double until) {
    known_[a].push_back({b, until});
    known_[b].push_back({a, until});
  }

  // The plates that is_apart() answers for: those known to be apart from this one after `time`.
  void look_at(int plate, double time) {
    std::erase_if(known_[plate], [&](const std::pair<int, double>& known) { return known.second <= time; });
    ++look_;
    for (const auto& [other, until] : known_[plate]) row_[other] = look_;
  }

  bool is_apart(int other) const { return row_[other] == look_; }

 private:
  std::vector<std::vector<std::pair<int, double>>> known_;  // of each plate: another one, and until when
  std::vector<long> row_;                                   // of each plate: the last look that found it
  long look_ = 0;
};

class Proof {
 public:
  Proof(const Linkage& linkage, PanelMotion& motion, const PathProofOptions& options, const Run& run)
      : motion_(motion), options_(options), run_(run) {
    proof_.clearance = options.clearance > 0 ? options.clearance : default_clearance(linkage);
    proof_.touch = options.touch > 0 ? options.touch : 1e-3 * proof_.clearance;
    proof_.rounding = 2 * motion.rounding();
    plates_ = proof_plates(linkage, proof_.clearance);
    known_apart_ = KnownApart(plates_.corners.size());
    boxes_.resize(plates_.corners.size());
    centers_.reserve(plates_.corners.size());
    for (const std::vector<Vec3>& corners : plates_.corners) {
      Vec3 sum = Vec3::Zero();
      for (const Vec3& corner : corners) sum += corner;
      centers_.push_back(sum / static_cast<double>(corners.size()));
    }
  }

  PathProof run() {
    proof_.verdict = PathVerdict::Free;
    std::vector<Pose>& start = level(0).first;
    std::vector<Pose>& end = level(0).second;
    start.resize(plates_.num_panels);
    end.resize(plates_.num_panels);
    motion_.place(0, {}, start);
    motion_.place(1, {}, end);
    std::vector<PlatePair> near;
    all_pairs(0, 1, start, end, 0, near);
    if (proof_.verdict == PathVerdict::Free) proof_.free_until = 1;
    return proof_;
  }

 private:
  using Poses = std::vector<Pose>;

  // Poses in the middle of the intervals of one depth of halving; a deque, so that references stay valid.
  std::pair<Poses, Poses>& level(int depth) {
    while (static_cast<int>(middles_.size()) <= depth) middles_.emplace_back();
    return middles_[depth];
  }

  bool done() {
    if (proof_.verdict != PathVerdict::Free) return true;
    const long looks = proof_.pair_intervals + proof_.intervals * static_cast<long>(boxes_.size());
    if (!run_.over() && (options_.max_looks == 0 || looks < options_.max_looks)) return false;
    proof_.interrupted = true;
    return true;
  }

  // All pairs of plates on [start, end]: boxes dismiss most of them, or the interval is halved. Neighbours stay near
  // for the whole motion and move little as they see each other: the pairs `near` each other just before are looked at
  // first, so that few intervals are for them alone. Leaves in `near` those that were so on this interval.
  void all_pairs(double start, double end, const Poses& at_start, const Poses& at_end, int depth,
                 std::vector<PlatePair>& near) {
    if (done()) return interrupt(start);
    run_.report("proof", std::lround(1e4 * start), 10000);
    ++proof_.intervals;
    motion_.look_at(start, end, at_start);
    const std::vector<PlatePair> apart = take_apart(near, end, at_start, at_end);
    std::vector<PlatePair> pairs;
    if (sweep_boxes(start, at_start, at_end, depth, pairs)) {
      near = pairs;
      settle_or_halve(start, end, at_start, at_end, std::move(pairs), depth);
    } else {
      halve(start, end, {}, depth, [&](double middle, const Poses& at_middle) {
        all_pairs(start, middle, at_start, at_middle, depth + 1, near);
        all_pairs(middle, end, at_middle, at_end, depth + 1, near);
      });
    }
    near.insert(near.end(), apart.begin(), apart.end());
  }

  // Those of the pairs that one look shows to be apart until `end`. The motion looks at an interval that ends there.
  std::vector<PlatePair> take_apart(std::vector<PlatePair>& pairs, double end, const Poses& at_start,
                                    const Poses& at_end) {
    std::vector<PlatePair> apart;
    std::erase_if(pairs, [&](PlatePair& pair) {
      if (done() || contacts_.contains({pair.a, pair.b})) return false;
      ++proof_.pair_intervals;
      if (!clear(pair, stray_of(pair), at_start, at_end)) return false;
      known_apart_.set(pair.a, pair.b, end);
      apart.push_back(pair);
      return true;
    });
    return apart;
  }

  // These pairs on [start, end]; those that remain undecided on its halves.
  void some_pairs(double start, double end, const Poses& at_start, const Poses& at_end, std::vector<PlatePair> pairs,
                  int depth) {
    if (done()) return interrupt(start);
    ++proof_.intervals;
    motion_.look_at(start, end, at_start);
    settle_or_halve(start, end, at_start, at_end, std::move(pairs), depth);
  }

  // One by one. The motion looks at [start, end] already.
  void settle_or_halve(double start, double end, const Poses& at_start, const Poses& at_end,
                       std::vector<PlatePair> pairs, int depth) {
    std::erase_if(pairs, [&](PlatePair& pair) {
      return proof_.verdict != PathVerdict::Free || settle(pair, start, end, at_start, at_end);
    });
    if (pairs.empty() || proof_.verdict != PathVerdict::Free) return;
    if (end - start < options_.resolution) return give_up(pairs.front(), start, end);
    std::vector<char> wanted(plates_.num_panels, 0);
    for (const PlatePair& pair : pairs) {
      motion_.want(plates_.panel[pair.a], wanted);
      motion_.want(plates_.panel[pair.b], wanted);
      if (pair.frame >= 0) motion_.want(pair.frame, wanted);
    }
    halve(start, end, wanted, depth, [&](double middle, const Poses& at_middle) {
      some_pairs(start, middle, at_start, at_middle, pairs, depth + 1);
      some_pairs(middle, end, at_middle, at_end, pairs, depth + 1);
    });
  }

  template <class Halves>
  void halve(double start, double end, const std::vector<char>& wanted, int depth, Halves halves) {
    const double middle = motion_.split(start, end);
    Poses& at_middle = level(depth + 1).first;
    at_middle.resize(plates_.num_panels);
    motion_.place(middle, wanted, at_middle);
    halves(middle, at_middle);
  }

  // Boxes around the chords of all corners, grown by what they can stray. False when too many pairs are left.
  bool sweep_boxes(double start, const Poses& at_start, const Poses& at_end, int depth, std::vector<PlatePair>& pairs) {
    const int n = static_cast<int>(boxes_.size());
    double stray = 0;
    for (int i = 0; i < n; ++i) {
      const int panel = plates_.panel[i];
      boxes_[i].plate = i;
      Eigen::AlignedBox3d& box = boxes_[i].box;
      box.setEmpty();
      for (const Vec3& corner : plates_.corners[i]) {
        box.extend(at_start[panel] * corner);
        box.extend(at_end[panel] * corner);
      }
      if (i == 0 || panel != plates_.panel[i - 1]) stray = motion_.bend(panel, -1) + proof_.rounding;
      box.min().array() -= stray;
      box.max().array() += stray;
    }
    std::sort(boxes_.begin(), boxes_.end(), [](const PlateBox& a, const PlateBox& b) {
      return a.box.min().x() < b.box.min().x() || (a.box.min().x() == b.box.min().x() && a.plate < b.plate);
    });
    const std::size_t most = depth < kMaxBulkHalvings ? kPairsPerPlateAndHalving * depth * n + 8 : pairs.max_size();
    for (int i = 0; i < n; ++i) {
      const Eigen::AlignedBox3d& box = boxes_[i].box;
      known_apart_.look_at(boxes_[i].plate, start);
      for (int j = i + 1; j < n && boxes_[j].box.min().x() <= box.max().x(); ++j) {
        const Eigen::AlignedBox3d& other = boxes_[j].box;
        // As numbers: four tests without a branch, for this is the inner loop.
        const int meet = int{other.min().y() <= box.max().y()} & int{box.min().y() <= other.max().y()} &
                         int{other.min().z() <= box.max().z()} & int{box.min().z() <= other.max().z()};
        if (meet == 0 || known_apart_.is_apart(boxes_[j].plate)) continue;
        const auto [a, b] = std::minmax(boxes_[i].plate, boxes_[j].plate);
        if (!plates_.may_collide(a, b)) continue;
        if (pairs.size() >= most) return false;
        pairs.push_back({a, b, motion_.frame_of(plates_.panel[a], plates_.panel[b]), Vec3::Zero()});
      }
    }
    return true;
  }

  // A plate's corners at one moment, seen from a frame.
  static void place(const std::vector<Vec3>& corners, const Pose& pose, const Pose* frame, std::vector<Vec3>& placed) {
    placed.resize(corners.size());
    const Eigen::Matrix3d turn = frame ? frame->linear().transpose() * pose.linear() : Eigen::Matrix3d(pose.linear());
    const Vec3 shift = frame ? Vec3(frame->linear().transpose() * (pose.translation() - frame->translation()))
                             : Vec3(pose.translation());
    for (std::size_t i = 0; i < corners.size(); ++i) placed[i] = turn * corners[i] + shift;
  }

  void place(const PlatePair& pair, const Poses& at_start, const Poses& at_end) {
    const auto frame = [&](const Poses& poses) { return pair.frame < 0 ? nullptr : &poses[pair.frame]; };
    const int a = plates_.panel[pair.a], b = plates_.panel[pair.b];
    place(plates_.corners[pair.a], at_start[a], frame(at_start), a_start_);
    place(plates_.corners[pair.b], at_start[b], frame(at_start), b_start_);
    place(plates_.corners[pair.a], at_end[a], frame(at_end), a_end_);
    place(plates_.corners[pair.b], at_end[b], frame(at_end), b_end_);
  }

  Separation separate(std::span<const Vec3> a, std::span<const Vec3> b) const {
    return plates_.are_thick ? separation_of_prisms(a, b) : separation(a, b);
  }

  double least_lead(const Vec3& direction) const {
    return std::min(lead(a_start_, b_start_, direction), lead(a_end_, b_end_, direction));
  }

  // From the centre of the second plate to that of the first, seen from the frame.
  Vec3 between_centres(const PlatePair& pair, const Poses& poses) const {
    const Vec3 apart =
        poses[plates_.panel[pair.a]] * centers_[pair.a] - poses[plates_.panel[pair.b]] * centers_[pair.b];
    const double distance = apart.norm();
    if (distance == 0) return Vec3::Zero();
    return pair.frame < 0 ? Vec3(apart / distance) : Vec3(poses[pair.frame].linear().transpose() * (apart / distance));
  }

  // The least (or, with sign -1, minus the greatest) coordinate of a plate along a direction of the world: the
  // direction is turned back into the flat state, which is cheaper than placing the corners.
  double extreme(int plate, const Poses& poses, const Vec3& direction, double sign) const {
    const Pose& pose = poses[plates_.panel[plate]];
    const Vec3 flat = sign * (pose.linear().transpose() * direction);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : plates_.corners[plate]) least = std::min(least, flat.dot(corner));
    return least + sign * pose.translation().dot(direction);
  }

  // lead() of the pair at one moment along its direction.
  double lead_at(const PlatePair& pair, const Poses& poses) const {
    const Vec3 direction = pair.frame < 0 ? pair.direction : Vec3(poses[pair.frame].linear() * pair.direction);
    return extreme(pair.a, poses, direction, 1) + extreme(pair.b, poses, direction, -1);
  }

  static void middle(const std::vector<Vec3>& p, const std::vector<Vec3>& q, std::vector<Vec3>& result) {
    result.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) result[i] = (p[i] + q[i]) / 2;
  }

  // How far the two stray from their chords together.
  double stray_of(const PlatePair& pair) const {
    return motion_.bend(plates_.panel[pair.a], pair.frame) + motion_.bend(plates_.panel[pair.b], pair.frame) +
           proof_.rounding;
  }

  // Does the direction from before, or else between the centres, separate the pair? A guess that settles most pairs at
  // a tenth of the price of their true separation.
  bool clear(PlatePair& pair, double stray, const Poses& at_start, const Poses& at_end) const {
    if (pair.direction == Vec3::Zero()) pair.direction = between_centres(pair, at_end);
    return pair.direction != Vec3::Zero() && lead_at(pair, at_start) > stray && lead_at(pair, at_end) > stray;
  }

  // True when the pair needs no further look on [start, end].
  bool settle(PlatePair& pair, double start, double end, const Poses& at_start, const Poses& at_end) {
    ++proof_.pair_intervals;
    const double stray = stray_of(pair);
    const bool is_clear = clear(pair, stray, at_start, at_end);
    if (is_clear && contacts_.empty()) return true;
    place(pair, at_start, at_end);
    if (is_clear) return same_side(pair, start, end, pair.direction, false);
    middle(a_start_, a_end_, a_middle_);
    middle(b_start_, b_end_, b_middle_);
    const Separation at_middle = separate(a_middle_, b_middle_);
    pair.direction = at_middle.direction;
    if (-at_middle.value > stray + proof_.touch) {
      collide(pair, start, end, -at_middle.value);
      return true;
    }
    double ahead = least_lead(at_middle.direction);
    if (ahead > stray) return same_side(pair, start, end, at_middle.direction, false);
    if (at_middle.value <= proof_.touch) {
      // Plates in one plane have no side of their own; the ends of the interval know it.
      if (const double behind = least_lead(-at_middle.direction); behind > ahead)
        ahead = behind, pair.direction = -pair.direction;
    }
    if (ahead - stray >= -proof_.touch) return same_side(pair, start, end, pair.direction, true);
    return false;
  }

  // Plates that come to touch from one side and go on on the other have passed through each other, however thin they
  // are: parallel ones never penetrate at any one moment. A contact keeps the side that it was entered from.
  bool same_side(const PlatePair& pair, double start, double end, const Vec3& direction, bool touching) {
    const std::pair<int, int> key{pair.a, pair.b};
    const auto last = contacts_.find(key);
    const bool goes_on = last != contacts_.end() && last->second.until == start;
    const Vec3 side = goes_on ? last->second.direction : touching ? side_at_start(direction) : direction;
    const bool turned = direction.dot(side) < 0;
    if (turned && crossed(side)) return give_up(pair, start, end), true;
    // What lies flat on each other is seen from either side; its own side turns with it.
    const bool may_turn_back = turned && least_lead(-direction) >= -proof_.touch;
    if (touching || turned)
      contacts_[key] = {end, may_turn_back ? Vec3(-direction) : turned ? side : direction};
    else if (last != contacts_.end())
      contacts_.erase(last);
    return true;
  }

  // Plates that are clear of each other when a contact begins tell its side; others have no side before `otherwise`.
  Vec3 side_at_start(const Vec3& otherwise) const {
    const Separation now = separate(a_start_, b_start_);
    return now.value > proof_.rounding ? now.direction : otherwise;
  }

  // Do plates that touch at the start lie beyond touch on the other side at the end? Plates that turn together while
  // they lie flat on each other leave `side` as it was, so the depth is taken along their own direction, too.
  bool crossed(const Vec3& side) const {
    if (lead(a_end_, b_end_, side) >= -proof_.touch) return false;
    if (std::abs(separate(a_start_, b_start_).value) > 2 * proof_.touch) return false;
    const Vec3 at_end = separate(a_end_, b_end_).direction;
    return at_end.dot(side) < 0 && lead(a_end_, b_end_, -at_end) < -proof_.touch;
  }

  void name_panels(const PlatePair& pair) {
    proof_.panel_a = std::min(plates_.panel[pair.a], plates_.panel[pair.b]);
    proof_.panel_b = std::max(plates_.panel[pair.a], plates_.panel[pair.b]);
  }

  void give_up(const PlatePair& pair, double start, double end) {
    proof_.verdict = PathVerdict::Undecided;
    proof_.from = proof_.free_until = start;
    proof_.to = end;
    name_panels(pair);
  }

  void interrupt(double start) {
    if (!proof_.interrupted || proof_.verdict != PathVerdict::Free) return;
    proof_.verdict = PathVerdict::Undecided;
    proof_.from = proof_.free_until = start;
    proof_.to = 1;
  }

  double depth_at(const PlatePair& pair, double time) {
    Poses& poses = level(0).second;  // the end of the motion is not needed any more
    motion_.place(time, {}, poses);
    place(pair, poses, poses);
    return -separate(a_start_, b_start_).value;
  }

  // The collision is certain in the middle; narrows down when it began by halving the time before.
  void collide(const PlatePair& pair, double start, double end, double depth_on_chord) {
    proof_.verdict = PathVerdict::Collides;
    proof_.free_until = start;  // time is looked at from its beginning
    name_panels(pair);
    double clear = start, inside = start + (end - start) / 2;
    proof_.depth = std::max(depth_at(pair, inside), depth_on_chord);
    if (depth_at(pair, clear) > 0) {
      inside = clear;
      for (double step = end - start; clear > 0 && depth_at(pair, clear) > 0; step *= 2)
        inside = clear, clear = std::max(0.0, clear - step);
    }
    for (int i = 0; i < 40 && inside - clear > 1e-9; ++i) {
      const double between = clear + (inside - clear) / 2;
      (depth_at(pair, between) > 0 ? inside : clear) = between;
    }
    proof_.from = clear;
    proof_.to = start + (end - start) / 2;
    while (proof_.to - clear > 2 * (inside - clear) + 1e-9 &&
           depth_at(pair, clear + (proof_.to - clear) / 2) > proof_.touch)
      proof_.to = clear + (proof_.to - clear) / 2;
    proof_.depth = depth_at(pair, proof_.to);
  }

  PanelMotion& motion_;
  const PathProofOptions& options_;
  const Run& run_;
  PathProof proof_;
  ProofPlates plates_;
  std::vector<Vec3> centers_;    // of each plate in the flat state
  std::vector<PlateBox> boxes_;  // along x
  std::deque<std::pair<Poses, Poses>> middles_;
  std::map<std::pair<int, int>, Contact> contacts_;
  KnownApart known_apart_{0};
  std::vector<Vec3> a_start_, b_start_, a_end_, b_end_, a_middle_, b_middle_;
};

void check(const PathProofOptions& options) {
  const auto length = [](double value, const char* what) {
    if (!(value >= 0) || !std::isfinite(value))
      throw InvalidOption(fmt::format("{} = {} must be a finite length, at least 0", what, value));
  };
  length(options.clearance, "clearance");
  length(options.touch, "touch");
  if (options.max_looks < 0) throw InvalidOption(fmt::format("max_looks = {} must be at least 0", options.max_looks));
  if (!(options.closing > 0)) throw InvalidOption(fmt::format("closing = {} must be above 0", options.closing));
  if (!(options.resolution > 0) || options.resolution > 1)
    throw InvalidOption(fmt::format("resolution = {} must be in (0, 1]", options.resolution));
}

void place_at_hinge(PathProof& proof, const Hinge& hinge) {
  proof.panel_a = std::min(hinge.left, hinge.right);
  proof.panel_b = std::max(hinge.left, hinge.right);
}

// A hinge keeps its two panels apart only up to 180 degrees.
std::optional<PathProof> over_folded(const Linkage& linkage, const FoldingPath& path) {
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    for (int h = 0; h < linkage.num_hinges(); ++h) {
      if (std::abs(path.waypoints[i].config[h]) <= kPi + 1e-9) continue;
      PathProof proof;
      proof.verdict = PathVerdict::Collides;
      proof.from = i > 0 ? path.waypoints[i - 1].time : 0;
      proof.to = path.waypoints[i].time;
      place_at_hinge(proof, linkage.hinges[h]);
      return proof;
    }
  }
  return {};
}

std::optional<PathProof> beyond_limits(const Linkage& linkage, const FoldingPath& path) {
  const int at = waypoint_beyond_limits(linkage, path);
  if (at < 0) return {};
  PathProof proof;
  proof.verdict = PathVerdict::BeyondLimits;
  proof.from = proof.to = path.waypoints[at].time;
  place_at_hinge(proof, linkage.hinges[hinge_beyond_limits(linkage, path.waypoints[at].config, kLimitRounding)]);
  return proof;
}

PathProof prove_sheet(const Linkage& linkage, const FoldingPath& path, PathProofOptions options, const Run& run) {
  SheetMotion motion(linkage, path);
  const LoopReport& loops = motion.loops();
  PathProof proof;
  proof.loops = loops;
  proof.clearance = options.clearance > 0 ? options.clearance : default_clearance(linkage);
  proof.touch = std::max(options.touch > 0 ? options.touch : 1e-3 * proof.clearance, loops.gap);
  if (loops.residual > options.closing) {
    proof.verdict = PathVerdict::NotClosed;
    proof.from = proof.to = path.waypoints[loops.waypoint].time;
    place_at_hinge(proof, linkage.hinges[loops.hinge]);
    return proof;
  }
  if (loops.gap >= proof.clearance) {
    proof.too_coarse = true;
    proof.from = path.waypoints[loops.gap_waypoint].time;
    proof.to = path.waypoints[loops.gap_waypoint + 1].time;
    place_at_hinge(proof, linkage.hinges[loops.gap_hinge]);
    return proof;
  }
  options.clearance = proof.clearance;
  options.touch = proof.touch;
  proof = prove_motion(linkage, motion, options, run);
  proof.loops = loops;
  return proof;
}

}  // namespace

std::string_view name(PathVerdict verdict) {
  switch (verdict) {
    case PathVerdict::Free:
      return "free";
    case PathVerdict::Collides:
      return "collides";
    case PathVerdict::Undecided:
      return "undecided";
    case PathVerdict::NotClosed:
      return "not closed";
    case PathVerdict::BeyondLimits:
      return "beyond limits";
  }
  return "unknown";
}

PathProof prove_motion(const Linkage& linkage, PanelMotion& motion, const PathProofOptions& options, const Run& run) {
  check(options);
  return Proof(linkage, motion, options, run).run();
}

PathProof prove_path(const Linkage& linkage, const FoldingPath& path, const PathProofOptions& options, const Run& run) {
  check(options);
  check_path(linkage, path);
  if (const auto collision = over_folded(linkage, path)) return *collision;
  if (const auto limited = beyond_limits(linkage, path)) return *limited;
  if (linkage.has_loops()) return prove_sheet(linkage, path, options, run);
  LinkageMotion motion(linkage, path);
  return prove_motion(linkage, motion, options, run);
}

}  // namespace plico
