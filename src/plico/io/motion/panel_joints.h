// The tree of a linkage as animation and robot files want it: every panel in a frame of its own that turns about one
// axis through the frame's origin. Flat, all frames are parallel to the sheet's.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/folding_path.h"

namespace plico {

struct PanelJoint {
  int parent = -1, hinge = -1;  // -1 for a root
  Vec3 origin = Vec3::Zero();   // of the panel's frame in the flat sheet: a point of the hinge; the sheet's for a root
  Vec3 offset = Vec3::Zero();   // the same, seen from the parent's origin
  Vec3 axis = Vec3::UnitX();    // unit; the panel turns right-handed about it by the hinge's fold angle
  std::vector<int> children;    // ascending
};
std::vector<PanelJoint> panel_joints(const Linkage& linkage);

// Panels with every parent before its children, depth first: the order in which simulators number nested bodies.
std::vector<int> depth_first(const Linkage& linkage, const std::vector<PanelJoint>& joints);

// A simulator's chains: longer ones crash or drift (MuJoCo's stack, accumulated error), so exporters warn.
constexpr int kDeepChain = 40;
std::vector<std::string> chain_warnings(const Linkage& linkage);

// The fold angles of one hinge over time, without the keys that a straight line through their neighbours makes
// needless. At least two keys.
struct AngleKey {
  double time = 0, angle = 0;
};
std::vector<AngleKey> angle_keys(const FoldingPath& path, int hinge);

}  // namespace plico
