#include "plico/stack/peel_step.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

constexpr int kMostHalvings = 32;

// Farthest distance of the box from the line.
double farthest(const OrientedBox& box, const Vec3& point, const Vec3& axis) {
  double most = 0;
  for (const Vec3& corner : corners_of(box)) {
    const Vec3 from = corner - point;
    most = std::max(most, (from - axis.dot(from) * axis).squaredNorm());
  }
  return std::sqrt(most);
}

Angles3 middle(const Angles3& a, const Angles3& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }

}  // namespace

PeelBodies::PeelBodies(const Linkage& chain, int sign, double air)
    : chain_(chain),
      sign_(sign),
      half_side_((chain.panels[0][1] - chain.panels[0][0]).norm() / 2),
      half_thickness_(chain.thickness / 2),
      air_(air * chain.thickness),
      radius_(Vec3(half_side_, half_side_, half_thickness_).norm()),
      pose_(folding_map(chain, goal(chain))) {
  for (int p = 0; p < chain.num_panels(); ++p) standing_.push_back(placed(panel(p), pose_[p]));
}

OrientedBox PeelBodies::panel(int p) const {
  const std::vector<Vec3>& outline = chain_.panels[p];
  return {(outline[0] + outline[2]) / 2, Eigen::Matrix3d::Identity(), {half_side_, half_side_, half_thickness_ - air_}};
}

OrientedBox PeelBodies::tower(int first, int on) const {
  OrientedBox box = panel(on);
  const int below = first - on, count = num_panels() - first;
  // The pile goes on upon the front of `on` when its next hinge is a valley.
  const double up = on + 1 < num_panels() && pile_angle(on) < 0 ? -1 : 1;
  box.half.z() = count * half_thickness_ - air_;
  box.center.z() += up * (2 * below + count - 1) * half_thickness_;
  return box;
}

PeelWindow::PeelWindow(const PeelBodies& bodies, int first, int count) : bodies_(bodies), first_(first), count_(count) {
  for (int i = 1; i < count; ++i) movers_.push_back({first + i, i, bodies.panel(first + i)});
  const int on = first + count;  // the tower's lowest panel is held by the last hinge; the rest of it is not
  movers_.push_back({on, count, bodies.panel(on)});
  if (on + 1 < bodies.num_panels()) movers_.push_back({on, count, bodies.tower(on + 1, on)});
  const int all = static_cast<int>(movers_.size());
  for (int a = 0; a < all; ++a)
    for (int b = a + 1; b < all; ++b) {
      const bool is_rest = b == count;
      const bool mates = movers_[b].depth == movers_[a].depth + 1 && !is_rest;
      if (movers_[a].depth < movers_[b].depth && !mates) inner_.push_back({b, a});
    }
}

Angles3 PeelWindow::start() const {
  Angles3 angles{};
  for (int i = 0; i < count_; ++i) angles[i] = bodies_.pile_angle(first_ + i);
  return angles;
}

Angles3 PeelWindow::end() const {
  Angles3 angles{};
  for (int i = 0; i < count_; ++i) angles[i] = bodies_.hinge(first_ + i).target;
  return angles;
}

void PeelWindow::place(const Angles3& angles, Placed& at) const {
  std::array<Pose, 4> pose;
  pose[0] = bodies_.pose(first_);
  for (int i = 0; i < count_; ++i) {
    const Hinge& hinge = bodies_.hinge(first_ + i);
    at.point[i] = pose[i] * hinge.from;
    at.axis[i] = pose[i].linear() * (hinge.to - hinge.from).normalized();
    pose[i + 1] = pose[i] * turn(hinge, angles[i], hinge.right == first_ + i + 1);
  }
  for (std::size_t m = 0; m < movers_.size(); ++m) at.box[m] = placed(movers_[m].local, pose[movers_[m].depth]);
}

const OrientedBox& PeelWindow::other_box(const Pair& pair, const Placed& at) const {
  return pair.other < 0 ? bodies_.standing(-1 - pair.other) : at.box[pair.other];
}

// How far the mover can get, as the other sees it, while every hinge turns by at most `half_turn` from where it is.
double PeelWindow::reach(const Pair& pair, const Placed& at, const Angles3& half_turn) const {
  const int below = pair.other < 0 ? 0 : movers_[pair.other].depth;
  double moved = 0;
  for (int i = movers_[pair.mover].depth - 1; i >= below; --i) {
    if (half_turn[i] == 0) continue;
    const double axes = std::sqrt(2.0) * bodies_.hinge(first_ + i).roll;
    moved += half_turn[i] * (farthest(at.box[pair.mover], at.point[i], at.axis[i]) + axes + moved);
  }
  return moved;
}

// Pairs that may come nearer than `slack`; the hinge keeps the first mover and panel `first` apart.
std::vector<PeelWindow::Pair> PeelWindow::near_pairs(const Placed& at, double slack) const {
  std::vector<Pair> pairs = inner_;
  for (int m = 0; m < static_cast<int>(movers_.size()); ++m) {
    const double near = slack + bodies_.radius();
    const int most = m == 0 ? first_ - 1 : first_;
    for (int p = 0; p <= most; ++p)
      if (distance(at.box[m], bodies_.standing(p).center) < near) pairs.push_back({m, -1 - p});
  }
  return pairs;
}

bool PeelWindow::free_at(const Angles3& angles) const {
  Placed at;
  place(angles, at);
  return !std::ranges::any_of(near_pairs(at, 0),
                              [&](const Pair& pair) { return gap(at.box[pair.mover], other_box(pair, at)) <= 0; });
}

bool PeelWindow::free_between(const Angles3& from, const Angles3& to, long& intervals) const {
  Placed at;
  place(middle(from, to), at);
  Angles3 half_turn;
  for (int i = 0; i < 3; ++i) half_turn[i] = std::abs(to[i] - from[i]) / 2;
  double most = 0;
  for (int m = 0; m < static_cast<int>(movers_.size()); ++m) most = std::max(most, reach({m, -1}, at, half_turn));
  return halve(from, to, near_pairs(at, most), 0, intervals);
}

bool PeelWindow::halve(const Angles3& from, const Angles3& to, const std::vector<Pair>& pairs, int depth,
                       long& intervals) const {
  ++intervals;
  const Angles3 half = middle(from, to);
  Placed at;
  place(half, at);
  Angles3 half_turn;
  for (int i = 0; i < 3; ++i) half_turn[i] = std::abs(to[i] - from[i]) / 2;
  std::vector<Pair> open;
  for (const Pair& pair : pairs) {
    const double wide = gap(at.box[pair.mover], other_box(pair, at));
    if (wide <= 0) return false;
    if (wide <= reach(pair, at, half_turn)) open.push_back(pair);
  }
  if (open.empty()) return true;
  if (depth == kMostHalvings) return false;
  return halve(from, half, open, depth + 1, intervals) && halve(half, to, open, depth + 1, intervals);
}

}  // namespace plico
