#include "plico/verify/panel_motion.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {

void check_path(const Linkage& linkage, const FoldingPath& path) {
  if (path.waypoints.size() < 2 || path.waypoints.front().time != 0 || path.waypoints.back().time != 1)
    throw InvalidInput("motion/times", "a motion needs waypoints from time 0 to time 1");
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Waypoint& w = path.waypoints[i];
    if (w.config.size() != linkage.num_hinges())
      throw InvalidInput("motion/angles", fmt::format("waypoint {} has {} fold angles, the linkage has {} hinges", i,
                                                      w.config.size(), linkage.num_hinges()));
    if (!w.config.allFinite()) throw InvalidInput("motion/angles", fmt::format("waypoint {} has an infinite angle", i));
    if (i > 0 && !(w.time > path.waypoints[i - 1].time))
      throw InvalidInput("motion/times", fmt::format("waypoint {} at time {} does not come after time {}", i, w.time,
                                                     path.waypoints[i - 1].time));
  }
}

LinkageMotion::LinkageMotion(const Linkage& linkage, const FoldingPath& path)
    : linkage_(linkage),
      path_(path),
      depth_(linkage.panels.size(), 0),
      center_(linkage.panels.size()),
      pivot_(linkage.panels.size(), Vec3::Zero()),
      axis_(linkage.panels.size(), Vec3::UnitX()),
      radius_(linkage.panels.size(), 0),
      link_(linkage.panels.size(), 0),
      turn_(linkage.panels.size(), 0),
      kink_(linkage.panels.size(), 0),
      turn_from_root_(linkage.panels.size(), 0) {
  check_path(linkage, path);
  std::vector<double> chain(linkage.panels.size(), 0);
  double reach = 0;
  for (int p : linkage.order) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& corner : linkage.panels[p]) sum += corner;
    center_[p] = sum / static_cast<double>(linkage.panels[p].size());
    for (const Vec3& corner : linkage.panels[p]) radius_[p] = std::max(radius_[p], (corner - center_[p]).norm());
    const int parent = linkage.parent_panel[p];
    if (parent < 0) {
      pivot_[p] = center_[p];
      reach = std::max(reach, center_[p].norm() + radius_[p]);
      continue;
    }
    const Hinge& hinge = linkage.hinges[linkage.parent_hinge[p]];
    pivot_[p] = (hinge.from + hinge.to) / 2;
    axis_[p] = (hinge.to - hinge.from).normalized();
    link_[p] = (pivot_[p] - pivot_[parent]).norm();
    depth_[p] = depth_[parent] + 1;
    chain[p] = chain[parent] + link_[p];
    reach = std::max(reach, chain[p] + (center_[p] - pivot_[p]).norm() + radius_[p] + center_[p].norm());
  }
  const int deepest = depth_.empty() ? 0 : *std::max_element(depth_.begin(), depth_.end());
  // Each step down a chain rounds a rotation and a translation once; 16 covers their dozen operations.
  rounding_ = 16 * 2.3e-16 * (deepest + 4) * reach;
}

void LinkageMotion::configure(double time, Configuration& config) const {
  const auto after = std::upper_bound(path_.waypoints.begin() + 1, path_.waypoints.end() - 1, time,
                                      [](double t, const Waypoint& w) { return t < w.time; });
  const Waypoint &a = *(after - 1), &b = *after;
  const double s = std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0);
  config = (1 - s) * a.config + s * b.config;
}

void LinkageMotion::place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const {
  configure(time, config_);
  if (wanted.empty()) return folding_map(linkage_, config_, poses);
  for (int p : linkage_.order) {
    if (!wanted[p]) continue;
    const int parent = linkage_.parent_panel[p], h = linkage_.parent_hinge[p];
    if (parent < 0) {
      poses[p].setIdentity();
      continue;
    }
    const double angle = p == linkage_.hinges[h].right ? -config_[h] : config_[h];
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis_[p]).toRotationMatrix();
    const Vec3& from = linkage_.hinges[h].from;
    poses[p].linear().noalias() = poses[parent].linear() * turn;
    poses[p].translation() = poses[parent].linear() * (from - turn * from) + poses[parent].translation();
    poses[p].makeAffine();
  }
}

void LinkageMotion::look_at(double start, double end, const std::vector<Pose>& at_start) {
  at_start_ = &at_start;
  configure(start, start_config_);
  configure(end, end_config_);
  const auto by_time = [](double t, const Waypoint& w) { return t < w.time; };
  const auto first = std::upper_bound(path_.waypoints.begin(), path_.waypoints.end(), start, by_time);
  std::fill(kink_.begin(), kink_.end(), 0);
  for (auto w = first; w != path_.waypoints.end() && w->time < end; ++w) {
    const double s = (w->time - start) / (end - start);
    inside_ = (1 - s) * start_config_ + s * end_config_;
    for (int p : linkage_.order)
      if (const int h = linkage_.parent_hinge[p]; h >= 0)
        kink_[p] = std::max(kink_[p], std::abs(w->config[h] - inside_[h]));
  }
  for (int p : linkage_.order) {
    const int h = linkage_.parent_hinge[p];
    if (h < 0) continue;
    turn_[p] = std::abs(end_config_[h] - start_config_[h]);
    turn_from_root_[p] = turn_from_root_[linkage_.parent_panel[p]] + turn_[p];
  }
}

double LinkageMotion::bend(int panel, int frame) const {
  const Vec3 center = (*at_start_)[panel] * center_[panel];
  const double below = frame < 0 ? 0 : turn_from_root_[frame];
  double straight =
      (center_[panel] - pivot_[panel]).norm() + radius_[panel];  // the chain pulled straight: never exceeded
  double travel = 0, bend = 0;
  for (int p = panel; p != frame && linkage_.parent_panel[p] >= 0; p = linkage_.parent_panel[p]) {
    const Pose& pose = (*at_start_)[p];
    const double now = (pose.linear() * axis_[p]).cross(center - pose * pivot_[p]).norm() + radius_[panel];
    const double reach = std::min(now + travel, straight);
    const double outer = turn_from_root_[p] - below, inner = outer - turn_[p];
    bend += reach * ((outer * outer - inner * inner) / 8 + kink_[p]);
    travel += reach * (turn_[p] + kink_[p]);
    straight += link_[p];
  }
  return bend;
}

int LinkageMotion::frame_of(int a, int b) const {
  while (a != b && (a >= 0 && b >= 0)) {
    if (depth_[a] < depth_[b]) std::swap(a, b);
    a = linkage_.parent_panel[a];
  }
  return a == b ? a : -1;
}

void LinkageMotion::want(int panel, std::vector<char>& wanted) const {
  for (int p = panel; p >= 0 && !wanted[p]; p = linkage_.parent_panel[p]) wanted[p] = 1;
}

}  // namespace plico
