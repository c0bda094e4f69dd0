#include "plico/stack/peel_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plico/base/libm.h"

namespace plico {
namespace {

constexpr int kMostHalvings = 32;
constexpr int kHalvingsOfAll = 4;       // then only what was near is looked at
constexpr double kFirstLook = 15;       // degrees
constexpr long kMostIntervals = 20000;  // of one way: a search that is asked to stop must not hang in a narrow place

// Farthest distance of the corners from the line.
double farthest(const std::array<Vec3, 8>& corners, const Vec3& point, const Vec3& axis) {
  double most = 0;
  for (const Vec3& corner : corners) {
    const Vec3 from = corner - point;
    most = std::max(most, (from - axis.dot(from) * axis).squaredNorm());
  }
  return std::sqrt(most);
}

// Is there a direction, of those in which two boxes can be told apart and from `b` to `a`, that will do?
template <class Test>
bool is_any_direction(const OrientedBox& a, const OrientedBox& b, const Test& will_do) {
  const Vec3 between = a.center - b.center;
  const auto will_do_outwards = [&](const Vec3& d) { return will_do(d.dot(between) < 0 ? Vec3(-d) : d); };
  for (int i = 0; i < 3; ++i)
    if (will_do_outwards(a.axes.col(i)) || will_do_outwards(b.axes.col(i))) return true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 direction = a.axes.col(i).cross(b.axes.col(j));
      const double length = direction.norm();
      if (length > 1e-3 && will_do_outwards(direction / length)) return true;
    }
  return false;
}

// Of the corners, seen from a point.
std::array<double, 8> shadow(const OrientedBox& box, const Vec3& direction, const Vec3& point) {
  const double middle = direction.dot(box.center - point);
  const Vec3 reach = (box.axes.transpose() * direction).cwiseProduct(box.half);
  const double x = reach.x(), y = reach.y(), z = reach.z();
  return {middle - x - y - z, middle - x - y + z, middle - x + y - z, middle - x + y + z,
          middle + x - y - z, middle + x - y + z, middle + x + y - z, middle + x + y + z};
}

double highest(const OrientedBox& box, const Vec3& direction) {
  return box.center.dot(direction) + (box.axes.transpose() * direction).cwiseAbs().dot(box.half);
}

// A point of the axis about which panel h + 1 turns there, in the flat frame of panel h: beyond 90 degrees the line in
// which the panels will touch, on the side of the panel at rest (R11).
Vec3 axis_point(const Hinge& hinge, double angle, bool right_moves) {
  if (std::abs(angle) <= kPi / 2) return hinge.from;
  const Vec3 axis = (hinge.to - hinge.from).normalized();
  const double before = right_moves ? 1 : -1;
  return hinge.from + hinge.roll * Vec3(-before * axis.y(), before * axis.x(), std::copysign(1.0, angle));
}

OpenAngles middle(const OpenAngles& a, const OpenAngles& b) {
  OpenAngles result;
  for (int i = 0; i < kMostOpen; ++i) result[i] = (a[i] + b[i]) / 2;
  return result;
}

}  // namespace

PeelWindow::PeelWindow(const PeelBodies& bodies, int first, int count) : bodies_(bodies), first_(first), count_(count) {
  // The tower's lowest panel is held by the last hinge; the rest of it is not.
  for (int i = 1; i <= count; ++i) movers_.push_back({first + i, i, false, bodies.panel(first + i)});
  for (const OrientedBox& piece : bodies.tower(first + count)) movers_.push_back({first + count, count, true, piece});
  const int all = static_cast<int>(movers_.size());
  for (int a = 0; a < all; ++a)
    for (int b = a + 1; b < all; ++b) {
      const bool mates = movers_[b].depth == movers_[a].depth + 1 && !movers_[b].is_tower;
      if (movers_[a].depth < movers_[b].depth && !mates) inner_.emplace_back(b, a);
    }
}

void PeelWindow::place(const OpenAngles& angles, Placed& at) const {
  std::array<Pose, kMostOpen + 1> pose;
  pose[0] = bodies_.pose(first_);
  for (int i = 0; i < count_; ++i) {
    const Hinge& hinge = bodies_.hinge(first_ + i);
    const bool right_moves = hinge.right == first_ + i + 1;
    at.point[i] = pose[i] * axis_point(hinge, angles[i], right_moves);
    at.axis[i] = pose[i].linear() * (hinge.to - hinge.from).normalized();
    pose[i + 1] = pose[i] * turn(hinge, angles[i], right_moves);
  }
  at.box.clear();
  at.box.reserve(movers_.size());
  for (const Body& mover : movers_) at.box.push_back(placed(mover.local, pose[mover.depth]));
}

PeelWindow::Interval PeelWindow::interval(const OpenAngles& from, const OpenAngles& to) const {
  Interval interval;
  place(middle(from, to), interval.at);
  for (int i = 0; i < count_; ++i) {
    interval.half_turn[i] = std::abs(to[i] - from[i]) / 2;
    for (double quarter : {-kPi / 2, kPi / 2})
      if (std::min(from[i], to[i]) < quarter && quarter < std::max(from[i], to[i])) interval.changes_axis[i] = true;
  }
  return interval;
}

// Seen by what hangs on the first `below` hinges.
PeelWindow::Motion PeelWindow::motion(int mover, int below, const Interval& interval) const {
  Motion motion;
  const Placed& at = interval.at;
  motion.body = at.box[mover];
  const std::array<Vec3, 8> corners = corners_of(motion.body);
  for (int i = movers_[mover].depth - 1; i >= below; --i) {
    const double half = interval.half_turn[i];
    if (half == 0) continue;
    double loose = motion.total;
    if (interval.changes_axis[i]) loose += std::sqrt(2.0) * bodies_.hinge(first_ + i).roll;
    const double length = half * (farthest(corners, at.point[i], at.axis[i]) + loose);
    motion.turns[motion.count++] = {at.axis[i], at.point[i], half, plico::sin(half), 1 - plico::cos(half), loose};
    motion.total += length;
  }
  return motion;
}

// A turn by at most `half` moves x, seen from its axis, by no more than sin(half) |u.(a x x)| + (1 - cos(half)) |u.x'|
// along u, where x' is x without its part along the axis. Concave in x, so the corners tell for the whole body.
double PeelWindow::Motion::against(const Vec3& direction) const {
  double always = 0;
  std::array<double, 8> height = shadow(body, direction, Vec3::Zero());
  for (int i = 0; i < count; ++i) {
    const Turning& turn = turns[i];
    const Vec3 across = turn.axis.cross(direction), aside = direction - turn.axis.dot(direction) * turn.axis;
    const std::array<double, 8> along = shadow(body, across, turn.point), away = shadow(body, aside, turn.point);
    for (int k = 0; k < 8; ++k) height[k] -= turn.sine * std::abs(along[k]) + turn.sag * std::abs(away[k]);
    always += turn.half * across.norm() * turn.loose;
  }
  return *std::ranges::min_element(height) - always;
}

bool PeelWindow::stays_clear(const OrientedBox& mover, const OrientedBox& other, double apart,
                             const Motion& motion) const {
  const double least = bodies_.least_gap();
  if (apart > motion.total + least) return true;
  return is_any_direction(mover, other, [&](const Vec3& d) {
    const double bound = highest(other, d) + least;
    return -highest(mover, -d) > bound && motion.against(d) > bound;  // most are told by where the mover is now
  });
}

// The hinge keeps the first mover and panel `first` apart.
int PeelWindow::last_standing(int mover) const { return mover == 0 ? first_ - 1 : first_; }

bool PeelWindow::is_hit(const Placed& at) const {
  for (const auto& [deep, other] : inner_)
    if (gap(at.box[deep], at.box[other]) <= bodies_.least_gap()) return true;
  for (int m = 0; m < static_cast<int>(movers_.size()); ++m) {
    const auto meets = [&](int panel) { return gap(at.box[m], bodies_.standing(panel)) <= bodies_.least_gap(); };
    if (bodies_.standing_trees().any_near(at.box[m], bodies_.least_gap(), last_standing(m), meets)) return true;
  }
  return false;
}

bool PeelWindow::is_clear(const Interval& interval) const {
  const std::vector<OrientedBox>& box = interval.at.box;
  const auto clear = [&](const OrientedBox& mover, const OrientedBox& other, const Motion& moved) {
    return stays_clear(mover, other, gap(mover, other), moved);
  };
  for (const auto& [deep, other] : inner_)
    if (!clear(box[deep], box[other], motion(deep, movers_[other].depth, interval))) return false;
  for (int m = 0; m < static_cast<int>(movers_.size()); ++m) {
    const Motion moved = motion(m, 0, interval);
    const auto may_meet = [&](int panel) { return !clear(box[m], bodies_.standing(panel), moved); };
    if (bodies_.standing_trees().any_near(box[m], moved.total + bodies_.least_gap(), last_standing(m), may_meet))
      return false;
  }
  return true;
}

bool PeelWindow::free_at(const OpenAngles& angles) const {
  Placed at;
  place(angles, at);
  return !is_hit(at);
}

bool PeelWindow::free_at_samples(const OpenAngles& from, const OpenAngles& to, double apart) const {
  double most = 0;
  for (int i = 0; i < count_; ++i) most = std::max(most, std::abs(to[i] - from[i]));
  const int pieces = static_cast<int>(std::ceil(degrees(most) / apart));
  for (int k = 1; k < pieces; ++k) {
    OpenAngles at{};
    for (int i = 0; i < count_; ++i) at[i] = from[i] + (to[i] - from[i]) * k / pieces;
    if (!free_at(at)) return false;
  }
  return true;
}

bool PeelWindow::free_between(const OpenAngles& from, const OpenAngles& to, long& intervals) const {
  // What collides mostly does so deeply: seen sooner than by halving, which begins where it is just free.
  return free_at_samples(from, to, kFirstLook) && halve(from, to, 0, intervals, intervals + kMostIntervals);
}

bool PeelWindow::halve(const OpenAngles& from, const OpenAngles& to, int depth, long& intervals, long most) const {
  if (depth == kHalvingsOfAll) return halve_near(from, to, near_pairs(interval(from, to)), depth, intervals, most);
  if (++intervals > most) return false;
  const Interval whole = interval(from, to);
  if (is_hit(whole.at)) return false;
  if (is_clear(whole)) return true;
  const OpenAngles half = middle(from, to);
  return halve(from, half, depth + 1, intervals, most) && halve(half, to, depth + 1, intervals, most);
}

std::vector<PeelWindow::Pair> PeelWindow::near_pairs(const Interval& interval) const {
  std::vector<Pair> pairs;
  for (const auto& [deep, other] : inner_) pairs.push_back({deep, other, false});
  for (int m = 0; m < static_cast<int>(movers_.size()); ++m) {
    const auto add = [&](int panel) {
      pairs.push_back({m, panel, true});
      return false;
    };
    const double slack = motion(m, 0, interval).total + bodies_.least_gap();
    bodies_.standing_trees().any_near(interval.at.box[m], slack, last_standing(m), add);
  }
  return pairs;
}

bool PeelWindow::halve_near(const OpenAngles& from, const OpenAngles& to, const std::vector<Pair>& pairs, int depth,
                            long& intervals, long most) const {
  if (++intervals > most || depth > kMostHalvings) return false;
  const Interval whole = interval(from, to);
  std::vector<Pair> left;
  Motion moved;
  int of = -1, seen_by = -1;  // whose motion that is
  for (const Pair& pair : pairs) {
    const OrientedBox& mover = whole.at.box[pair.mover];
    const OrientedBox& other = pair.stands ? bodies_.standing(pair.other) : whole.at.box[pair.other];
    const double apart = gap(mover, other);
    if (apart <= bodies_.least_gap()) return false;
    const int below = pair.stands ? 0 : movers_[pair.other].depth;
    if (pair.mover != of || below != seen_by) moved = motion(of = pair.mover, seen_by = below, whole);
    if (!stays_clear(mover, other, apart, moved)) left.push_back(pair);
  }
  if (left.empty()) return true;
  const OpenAngles half = middle(from, to);
  return halve_near(from, half, left, depth + 1, intervals, most) &&
         halve_near(half, to, left, depth + 1, intervals, most);
}

}  // namespace plico
