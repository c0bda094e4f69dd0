#include "plico/verify/panel_motion.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/libm.h"

namespace plico {

constexpr int kHingesBetweenAnchors = 16;

// Of a thick hinge: -1 below the panels, 0 in the mid-plane, 1 above.
static int axis_in_use(double angle) { return angle > kPi / 2 ? 1 : angle < -kPi / 2 ? -1 : 0; }

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
      links_(linkage.panels.size()),
      chains_(linkage.panels.size()),
      world_views_(linkage.panels.size()),
      ancestry_(linkage.parent_panel, linkage.order) {
  check_path(linkage, path);
  std::vector<double> chain(linkage.panels.size(), 0);
  double reach = 0;
  int deepest = 0;
  for (int p : linkage.order) {
    Link& link = links_[p];
    Vec3 sum = Vec3::Zero();
    for (const Vec3& corner : linkage.panels[p]) sum += corner;
    link.center = sum / static_cast<double>(linkage.panels[p].size());
    for (const Vec3& corner : linkage.panels[p]) link.radius = std::max(link.radius, (corner - link.center).norm());
    link.radius = plico::hypot(link.radius, linkage.thickness / 2);
    const int parent = link.parent = linkage.parent_panel[p];
    link.anchor = ancestry_.depth(p) % kHingesBetweenAnchors == 0 ? p : links_[parent].anchor;
    if (parent < 0) {
      link.pivot = link.center;
      reach = std::max(reach, link.center.norm() + link.radius);
      continue;
    }
    const Hinge& hinge = linkage.hinges[linkage.parent_hinge[p]];
    link.pivot = (hinge.from + hinge.to) / 2;
    link.axis = (hinge.to - hinge.from).normalized();
    link.axes = hinge.roll * std::sqrt(2.0);
    link.length = (link.pivot - links_[parent].pivot).norm() + 2 * link.axes;
    chain[p] = chain[parent] + link.length;
    deepest = std::max(deepest, ancestry_.depth(p));
    reach = std::max(reach, chain[p] + (link.center - link.pivot).norm() + link.radius + link.center.norm());
  }
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
    poses[p] = poses[parent] * turn(linkage_.hinges[h], config_[h], p == linkage_.hinges[h].right);
  }
}

void LinkageMotion::look_at(double start, double end, const std::vector<Pose>& at_start) {
  at_start_ = &at_start;
  ++look_;
  configure(start, start_config_);
  configure(end, end_config_);
  for (int p : linkage_.order) {
    Link& link = links_[p];
    const int h = linkage_.parent_hinge[p];
    if (h < 0) continue;
    link.kink = 0;
    link.turn = std::abs(end_config_[h] - start_config_[h]);
  }
  const auto by_time = [](double t, const Waypoint& w) { return t < w.time; };
  const auto first = std::upper_bound(path_.waypoints.begin(), path_.waypoints.end(), start, by_time);
  for (auto w = first; w != path_.waypoints.end() && w->time < end; ++w) {
    const double s = (w->time - start) / (end - start);
    inside_ = (1 - s) * start_config_ + s * end_config_;
    for (int p : linkage_.order)
      if (const int h = linkage_.parent_hinge[p]; h >= 0)
        links_[p].kink = std::max(links_[p].kink, std::abs(w->config[h] - inside_[h]));
  }
  for (int p : linkage_.order)
    if (Link& link = links_[p]; link.axes > 0) {
      const int h = linkage_.parent_hinge[p];
      const bool one_axis = link.kink == 0 && axis_in_use(start_config_[h]) == axis_in_use(end_config_[h]);
      link.slip = one_axis ? 0 : (link.turn + 2 * link.kink) * link.axes;
    }
}

// Many panels hang on a hinge: it is placed in the world once an interval, and only when somebody asks.
const LinkageMotion::Link& LinkageMotion::seen(int panel) const {
  Link& link = links_[panel];
  if (link.seen_at == look_) return link;
  const Pose& pose = (*at_start_)[panel];
  link.seen_at = look_;
  link.axis_now.noalias() = pose.linear() * link.axis;
  link.pivot_now = pose.linear() * link.pivot + pose.translation();
  return link;
}

void LinkageMotion::begin(Chain& chain, int panel) const {
  const Link& link = links_[panel];
  chain.seen_at = look_;
  chain.sums.clear();
  chain.next = panel;
  chain.straight = (link.center - link.pivot).norm() + link.radius;
  chain.center = (*at_start_)[panel] * link.center;
}

// Adds the next hinge up the chain.
void LinkageMotion::Chain::climb(const Link& link, double radius) {
  const Sums before = sums.empty() ? Sums{} : sums.back();
  const double now = link.axis_now.cross(center - link.pivot_now).norm() + radius;
  const double reach = std::min(now + before.travel, straight) + link.axes;
  sums.push_back({before.turn + link.turn, before.kink + link.kink, before.reach_turn + reach * link.turn,
                  before.less + reach * (link.turn * (2 * before.turn + link.turn) / 8 - link.kink) - link.slip / 4,
                  before.travel + reach * (link.turn + link.kink)});
  straight += link.length;
}

// The sums over so many hinges, at least one.
const LinkageMotion::Sums& LinkageMotion::climb(Chain& chain, int panel, int hinges) const {
  if (chain.seen_at != look_) begin(chain, panel);
  for (; static_cast<int>(chain.sums.size()) < hinges; chain.next = links_[chain.next].parent)
    chain.climb(seen(chain.next), links_[panel].radius);
  return chain.sums[hinges - 1];
}

// Seen from the panel, turns add up toward the frame: S_j^2 - S_(j-1)^2 = D_j (2 S_k - 2 T_j - D_j) with the turns T_j
// between hinge j and the panel and S_k of the whole chain. So all frames share the sums along one climb. The
// difference loses digits, at most as many as the chain has hinges times the rounding of its larger part.
static double quarter(int hinges) { return 0.25 + 1e-15 * hinges; }

LinkageMotion::View LinkageMotion::view(Chain& chain, int panel, int hinges) const {
  if (hinges == 0) return {};
  const Sums& sums = climb(chain, panel, hinges);
  return {quarter(hinges) * sums.turn * sums.reach_turn - sums.less, sums.turn,
          quarter(hinges) * sums.turn * sums.turn / 2 + sums.kink};
}

// Chains to the root of a large sheet would fill the memory, so what they come to is kept instead.
const LinkageMotion::View& LinkageMotion::from_world(int anchor) const {
  WorldView& world = world_views_[anchor];
  if (world.seen_at == look_) return world.view;
  begin(to_world_, anchor);
  world = {view(to_world_, anchor, ancestry_.depth(anchor)), look_};
  return world.view;
}

double LinkageMotion::bend(int panel, int frame) const {
  const int anchor = links_[panel].anchor, depth = ancestry_.depth(panel), near = depth - ancestry_.depth(anchor);
  const int hinges = depth - (frame < 0 ? 0 : ancestry_.depth(frame));
  if (frame < 0 && near == 0) return from_world(anchor).bend;
  Chain& chain = chains_[panel];
  if (near == 0 || (frame >= 0 && hinges < near + kHingesBetweenAnchors)) return view(chain, panel, hinges).bend;
  // A point is no farther from the hinges beyond the anchor than the anchor's centre and its own distance from there.
  const View beyond = frame < 0 ? from_world(anchor) : view(chains_[anchor], anchor, hinges - near);
  const Sums& sums = climb(chain, panel, near);
  const Vec3 center = (*at_start_)[anchor] * links_[anchor].center;
  const double farther = (chain.center - center).norm() + links_[panel].radius - links_[anchor].radius + sums.travel;
  return beyond.bend + beyond.weight * std::max(farther, 0.0) +
         quarter(depth) * (beyond.turn + sums.turn) * sums.reach_turn - sums.less;
}

void LinkageMotion::want(int panel, std::vector<char>& wanted) const {
  for (int p = panel; p >= 0 && !wanted[p]; p = linkage_.parent_panel[p]) wanted[p] = 1;
}

}  // namespace plico
