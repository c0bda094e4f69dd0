#include "plico/io/motion/panel_joints.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {

std::vector<PanelJoint> panel_joints(const Linkage& linkage) {
  std::vector<PanelJoint> joints(linkage.panels.size());
  for (int p : linkage.order) {
    const int h = linkage.parent_hinge[p];
    if (h < 0) continue;
    const Hinge& hinge = linkage.hinges[h];
    PanelJoint& joint = joints[p];
    joint.parent = linkage.parent_panel[p];
    joint.hinge = h;
    joint.origin = hinge.from;
    joint.offset = hinge.from - joints[joint.parent].origin;
    // Turning the right panel up (a valley) is a left-handed turn about from -> to.
    const Vec3 along = (hinge.to - hinge.from).normalized();
    joint.axis = p == hinge.left ? along : Vec3(-along);
    joints[joint.parent].children.push_back(p);
  }
  for (PanelJoint& joint : joints) std::sort(joint.children.begin(), joint.children.end());
  return joints;
}

std::vector<int> depth_first(const Linkage& linkage, const std::vector<PanelJoint>& joints) {
  std::vector<int> order, stack;
  for (auto p = linkage.order.rbegin(); p != linkage.order.rend(); ++p)
    if (joints[*p].parent < 0) stack.push_back(*p);
  while (!stack.empty()) {
    const int p = stack.back();
    stack.pop_back();
    order.push_back(p);
    stack.insert(stack.end(), joints[p].children.rbegin(), joints[p].children.rend());
  }
  return order;
}

std::vector<std::string> chain_warnings(const Linkage& linkage) {
  const int depth = chain_depth(linkage);
  if (depth <= kDeepChain) return {};
  return {
      fmt::format("the longest chain has {} hinges; simulators become slow or unstable above {}", depth, kDeepChain)};
}

std::vector<AngleKey> angle_keys(const FoldingPath& path, int hinge) {
  std::vector<AngleKey> keys;
  const auto rate = [](const AngleKey& a, const AngleKey& b) { return (b.angle - a.angle) / (b.time - a.time); };
  for (const Waypoint& waypoint : path.waypoints) {
    const AngleKey key{waypoint.time, waypoint.config[hinge]};
    const std::size_t n = keys.size();
    if (n >= 2 && std::abs(rate(keys[n - 2], keys[n - 1]) - rate(keys[n - 1], key)) < 1e-9) keys.pop_back();
    keys.push_back(key);
  }
  return keys;
}

}  // namespace plico
