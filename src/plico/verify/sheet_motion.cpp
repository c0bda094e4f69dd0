#include "plico/verify/sheet_motion.h"

#include <algorithm>
#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

constexpr double kRounding = 16 * 2.3e-16;  // of one step down a chain, relative: covers its dozen operations

// Bad near zero is acos; this form is not.
double angle_of(const Eigen::Quaterniond& q) { return 2 * plico::atan2(q.vec().norm(), std::abs(q.w())); }
double angle_of(const Eigen::Matrix3d& turn) { return angle_of(Eigen::Quaterniond(turn)); }

double diagonal(const Linkage& linkage) {
  Eigen::AlignedBox3d box;
  for (const auto& panel : linkage.panels)
    for (const Vec3& corner : panel) box.extend(corner);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

SheetMotion::SheetMotion(const Linkage& linkage, const FoldingPath& path) : linkage_(linkage), path_(path) {
  check_path(linkage, path);
  for (const auto& panel : linkage.panels) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& corner : panel) sum += corner;
    center_.emplace_back(sum / static_cast<double>(panel.size()));
    double radius = 0;
    for (const Vec3& corner : panel) radius = std::max(radius, (corner - center_.back()).norm());
    radius_.push_back(plico::hypot(radius, linkage.thickness / 2));
  }
  double reach = 0;
  for (int p = 0; p < linkage.num_panels(); ++p) reach = std::max(reach, center_[p].norm() + radius_[p]);
  rounding_ = kRounding * 4 * 2 * reach;  // poses at waypoints are what they are; only what follows is rounded
  loops_.loops = static_cast<int>(linkage.loop_hinges.size());
  std::vector<Pose> poses;
  for (int w = 0; w < static_cast<int>(path.waypoints.size()); ++w) {
    folding_map(linkage, path.waypoints[w].config, poses);
    measure_closing(w, poses);
    std::vector<Stand>& stands = stands_.emplace_back();
    for (int p = 0; p < linkage.num_panels(); ++p) {
      stands.push_back({Eigen::Quaterniond(poses[p].linear()).normalized(), poses[p] * center_[p]});
      // The shorter of the two ways around.
      if (w > 0 && stands_[w - 1][p].turn.dot(stands[p].turn) < 0) stands[p].turn.coeffs() *= -1;
    }
  }
  bound_gaps();
}

void SheetMotion::measure_closing(int waypoint, const std::vector<Pose>& poses) {
  const Configuration& config = path_.waypoints[waypoint].config;
  for (int h : linkage_.loop_hinges) {
    const Hinge& hinge = linkage_.hinges[h];
    const Pose &left = poses[hinge.left], &right = poses[hinge.right];
    const Vec3 axis = (hinge.to - hinge.from).normalized();
    const Eigen::Matrix3d wanted = left.linear() * rotation(axis, -config[h]);
    const double residual = angle_of(Eigen::Matrix3d(wanted.transpose() * right.linear()));
    for (const Vec3& end : {hinge.from, hinge.to})
      loops_.tear = std::max(loops_.tear, (left * end - right * end).norm());
    if (loops_.hinge >= 0 && residual <= loops_.residual) continue;
    loops_.residual = residual;
    loops_.waypoint = waypoint;
    loops_.hinge = h;
  }
}

void SheetMotion::bound_gaps() {
  for (int w = 0; w + 1 < static_cast<int>(stands_.size()); ++w) {
    std::vector<double>& bend = arcs_.emplace_back();
    for (int p = 0; p < linkage_.num_panels(); ++p) {
      const double turn = angle_of(stands_[w][p].turn.conjugate() * stands_[w + 1][p].turn);
      bend.push_back(turn * turn / 8);
    }
    gaps_.push_back(0);
    for (int h = 0; h < linkage_.num_hinges(); ++h) {
      const Hinge& hinge = linkage_.hinges[h];
      double gap = 0;
      for (const Vec3& end : {hinge.from, hinge.to})
        gap = std::max(gap, bend[hinge.left] * (end - center_[hinge.left]).norm() +
                                bend[hinge.right] * (end - center_[hinge.right]).norm());
      // A rotation's entries stray from their chords like points at distance 1; the hinge's own turn strays likewise.
      const double own = path_.waypoints[w + 1].config[h] - path_.waypoints[w].config[h];
      loops_.twist = std::max(loops_.twist, 2 * (bend[hinge.left] + bend[hinge.right]) + own * own / 4);
      // Panels go the short way around; a fold angle that goes the long way would lead them through each other.
      if (std::abs(own) > kPi / 2) gap = std::max(gap, (hinge.to - hinge.from).norm());
      gaps_.back() = std::max(gaps_.back(), gap);
      if (gap <= loops_.gap && loops_.gap_hinge >= 0) continue;
      loops_.gap = gap;
      loops_.gap_hinge = h;
      loops_.gap_waypoint = w;
    }
  }
  loops_.gap += loops_.tear;
  loops_.twist += loops_.residual;
  const double size = diagonal(linkage_);
  loops_.gap_share = size > 0 ? loops_.gap / size : 0;
}

SheetMotion::Moment SheetMotion::moment(double time) const {
  const auto after = std::upper_bound(path_.waypoints.begin() + 1, path_.waypoints.end() - 1, time,
                                      [](double t, const Waypoint& w) { return t < w.time; });
  const Waypoint &a = *(after - 1), &b = *after;
  return {static_cast<int>(after - path_.waypoints.begin()) - 1,
          std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0)};
}

SheetMotion::Stand SheetMotion::stand(int panel, const Moment& moment) const {
  const Stand &a = stands_[moment.before][panel], &b = stands_[moment.before + 1][panel];
  if (moment.share == 0) return a;
  if (moment.share == 1) return b;
  return {slerp(a.turn, b.turn, moment.share), a.center + moment.share * (b.center - a.center)};
}

void SheetMotion::place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const {
  const Moment now = moment(time);
  for (int p = 0; p < linkage_.num_panels(); ++p) {
    if (!wanted.empty() && !wanted[p]) continue;
    const Stand stands = stand(p, now);
    poses[p].linear() = stands.turn.toRotationMatrix();
    poses[p].translation() = stands.center - poses[p].linear() * center_[p];
    poses[p].makeAffine();
  }
}

void SheetMotion::look_at(double start, double end, const std::vector<Pose>& /*at_start*/) {
  start_ = start;
  end_ = end;
  at_start_ = moment(start);
  at_end_ = moment(end);
  first_inside_ = at_start_.before + 1;
  last_inside_ = at_end_.share > 0 ? at_end_.before : at_end_.before - 1;
}

// How far the panel's points at the waypoints inside the interval are from the chords of the interval.
double SheetMotion::stray(int panel) const {
  const Stand a = stand(panel, at_start_), b = stand(panel, at_end_);
  const Eigen::Matrix3d from = a.turn.toRotationMatrix(), to = b.turn.toRotationMatrix();
  double worst = 0;
  for (int w = first_inside_; w <= last_inside_; ++w) {
    const double share = (path_.waypoints[w].time - start_) / (end_ - start_);
    const Stand& here = stands_[w][panel];
    const Eigen::Matrix3d off = (1 - share) * from + share * to - here.turn.toRotationMatrix();
    worst =
        std::max(worst, ((1 - share) * a.center + share * b.center - here.center).norm() + radius_[panel] * off.norm());
  }
  return worst;
}

// Between waypoints points are within r theta^2 / 8 of a polyline, and that within stray() of the chord.
double SheetMotion::bend(int panel, int /*frame*/) const {
  const auto arc = [&](int waypoint, double share) { return radius_[panel] * share * share * arcs_[waypoint][panel]; };
  if (first_inside_ > last_inside_) {
    const bool ends_later = at_end_.before > at_start_.before;  // at the very waypoint
    return arc(at_start_.before, (ends_later ? 1 : at_end_.share) - at_start_.share);
  }
  double arcs = std::max(arc(at_start_.before, 1 - at_start_.share), arc(at_end_.before, at_end_.share));
  for (int w = first_inside_; w < last_inside_; ++w) arcs = std::max(arcs, arc(w, 1));
  return arcs + stray(panel);
}

double SheetMotion::split(double start, double end) const {
  const double middle = start + (end - start) / 2;
  const int before = moment(middle).before;
  const double earlier = path_.waypoints[before].time, later = path_.waypoints[before + 1].time;
  const bool has_earlier = earlier > start, has_later = later < end;
  if (has_earlier && (!has_later || middle - earlier <= later - middle)) return earlier;
  return has_later ? later : middle;
}

}  // namespace plico
