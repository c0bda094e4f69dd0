#include "plico/verify/chain_segment.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

constexpr double kPiledAngle = 1e-9;  // radians
constexpr double kPiledPlace = 1e-9;  // of a side

struct TurningLine {
  Vec3 point, direction;  // right-handed turns about it open the hinge towards valleys
};

// The line about which a hinge turns the panel behind it at an angle, as the panel before it sees it (R11).
TurningLine line_of_turn(const Hinge& hinge, double fold_angle, bool right_moves) {
  const Vec3 axis = (hinge.to - hinge.from).normalized(), direction = right_moves ? Vec3(-axis) : axis;
  if (std::abs(fold_angle) <= kPi / 2) return {hinge.from, direction};
  const Vec3 inwards(direction.y(), -direction.x(), std::copysign(1.0, fold_angle));
  return {hinge.from + hinge.roll * inwards, direction};
}

}  // namespace

ChainPoses::ChainPoses(const Linkage& chain)
    : chain_(chain), turns_(chain.num_hinges()), poses_(chain.num_panels(), Pose::Identity()) {}

void ChainPoses::fold(const Configuration& config) {
  const bool is_first = config_.size() == 0;
  int moved = chain_.num_hinges();
  for (int h = chain_.num_hinges() - 1; h >= 0; --h) {
    if (!is_first && config[h] == config_[h]) continue;
    turns_[h] = turn(chain_.hinges[h], config[h], chain_.hinges[h].right == h + 1);
    moved = h;
  }
  for (int h = moved; h < chain_.num_hinges(); ++h) poses_[h + 1] = poses_[h] * turns_[h];
  config_ = config;
}

ChainSegment::ChainSegment(const Linkage& chain, const std::vector<Pose>& start, const Configuration& from,
                           const Configuration& to, double air)
    : chain_(chain), start_(start), from_(from), to_(to), air_(air * chain.thickness) {
  for (int h = 0; h < chain.num_hinges(); ++h)
    if (from[h] != to[h]) moving_.push_back(h);
  int first = 0;
  for (int m = 0; m <= num_moving(); ++m) {
    const int last = m < num_moving() ? moving_[m] : chain.num_panels() - 1;
    add_group(m, first, last);
    first = last + 1;
  }
}

// The panels beside a moving hinge stand alone: they are mates across it. Upon the hinge before it a pile is cut into
// pieces, the first a side high and each as long as all before it: what is near the hinge moves little, and may be near
// much.
void ChainSegment::add_group(int group, int first, int last) {
  const std::size_t begin = blocks_.size();
  const int a_side = std::max(1, static_cast<int>(side() / chain_.thickness));
  for (int p = first; p <= last;) {
    int end = p;
    const bool alone = (p == first && group > 0) || (p == last && group < num_moving());
    const int longest = group > 0 ? std::max(a_side, p - first) : chain_.num_panels();
    while (!alone && end < last && end - p + 1 < longest && !(end + 1 == last && group < num_moving()) &&
           is_piled(p, end + 1))
      ++end;
    add_block(group, p, end);
    p = end + 1;
  }
  std::vector<Sphere>& spheres = spheres_.emplace_back(1);
  spheres.reserve(2 * (blocks_.size() - begin));
  add_sphere(spheres, 0, begin, blocks_.size());
}

// Does panel `next` lie in the pile that begins with `first`: straight above or below it?
bool ChainSegment::is_piled(int first, int next) const {
  if (std::abs(std::abs(from_[next - 1]) - kPi) > kPiledAngle) return false;
  const Vec3 up = start_[first].linear().col(2), off = center(next) - center(first);
  return (off - off.dot(up) * up).norm() < kPiledPlace * side() &&
         std::abs(std::abs(up.dot(start_[next].linear().col(2))) - 1) < kPiledPlace;
}

void ChainSegment::add_block(int group, int first, int last) {
  double low = 0, high = 0;
  for (int p = first + 1; p <= last; ++p) {
    const double z = start_[first].linear().col(2).dot(center(p) - center(first));
    low = std::min(low, z);
    high = std::max(high, z);
  }
  low -= chain_.thickness / 2 - air_;
  high += chain_.thickness / 2 - air_;
  const OrientedBox flat{middle(first) + (low + high) / 2 * Vec3::UnitZ(),
                         Eigen::Matrix3d::Identity(),
                         {side() / 2, side() / 2, (high - low) / 2}};
  blocks_.push_back({group, first, last, placed(flat, start_[first]), flat.half.norm()});
}

void ChainSegment::add_sphere(std::vector<Sphere>& spheres, std::size_t at, std::size_t from, std::size_t to) const {
  Vec3 low = blocks_[from].box.center, high = low;
  for (std::size_t i = from + 1; i < to; ++i) {
    low = low.cwiseMin(blocks_[i].box.center);
    high = high.cwiseMax(blocks_[i].box.center);
  }
  Sphere sphere;
  sphere.center = (low + high) / 2;
  sphere.first = from;
  for (std::size_t i = from; i < to; ++i)
    sphere.radius = std::max(sphere.radius, (blocks_[i].box.center - sphere.center).norm() + blocks_[i].radius);
  if (to - from > 1) sphere.left = spheres.size();
  spheres[at] = sphere;
  if (sphere.is_leaf()) return;
  spheres.resize(spheres.size() + 2);
  add_sphere(spheres, sphere.left, from, (from + to) / 2);
  add_sphere(spheres, sphere.left + 1, (from + to) / 2, to);
}

bool ChainSegment::are_mates(const ChainBlock& a, const ChainBlock& b) const {
  return b.group == a.group + 1 && a.first == a.last && b.first == b.last && a.last == moving_[a.group] &&
         b.first == a.last + 1;
}

// Arms run from axis to axis through rigid groups, so they keep their length but for the change of axes of a thick
// hinge.
double ChainSegment::speed(int group, const ChainBlock& b) const {
  double arm = 0, sum = 0;
  Vec3 at = b.box.center;
  for (int m = b.group - 1; m >= group; --m) {
    const Hinge& hinge = chain_.hinges[moving_[m]];
    const Vec3 axis_point = start_[moving_[m]] * Vec3((hinge.from + hinge.to) / 2);
    arm += (at - axis_point).norm() + 2 * std::sqrt(2.0) * hinge.roll + (m == b.group - 1 ? b.radius : 0);
    sum += std::abs(to_[moving_[m]] - from_[moving_[m]]) * arm;
    at = axis_point;
  }
  return sum;
}

std::vector<double> ChainSegment::changes_of_axis(int a, int b) const {
  std::vector<double> changes;
  for (int m = a; m < b; ++m) {
    const int h = moving_[m];
    for (double quarter : {-kPi / 2, kPi / 2}) {
      const double time = (quarter - from_[h]) / (to_[h] - from_[h]);
      if (chain_.hinges[h].roll > 0 && time > 0 && time < 1) changes.push_back(time);
    }
  }
  std::ranges::sort(changes);
  return changes;
}

// The pose of the panel before the m-th moving hinge: rest since the hinge before it, as at the start. `now` is that of
// the panel behind the latter.
Pose ChainSegment::before_turning(int a, int m, const Pose& now) const {
  if (m == a) return start_[moving_[a]];
  return now * (start_[moving_[m - 1] + 1].inverse(Eigen::Isometry) * start_[moving_[m]]);
}

ChainSegment::Turns ChainSegment::turns(int a, int b, double time, double end) const {
  Turns result;
  Pose now = Pose::Identity();
  for (int m = a; m < b; ++m) {
    const int h = moving_[m];
    const Hinge& hinge = chain_.hinges[h];
    const bool right_moves = hinge.right == h + 1;
    now = before_turning(a, m, now);
    const TurningLine line = line_of_turn(hinge, angle(h, (time + end) / 2), right_moves);
    result.turns.push_back({now * line.point, now.linear() * line.direction * (to_[h] - from_[h])});
    now = now * turn(hinge, angle(h, time), right_moves);
  }
  result.pose = now * start_[moving_[b - 1] + 1].inverse(Eigen::Isometry);
  return result;
}

Pose ChainSegment::moved(int a, int b, double time) const {
  Pose now = Pose::Identity();
  for (int m = a; m < b; ++m) {
    const int h = moving_[m];
    now = before_turning(a, m, now) * turn(chain_.hinges[h], angle(h, time), chain_.hinges[h].right == h + 1);
  }
  return now * start_[moving_[b - 1] + 1].inverse(Eigen::Isometry);
}

}  // namespace plico
