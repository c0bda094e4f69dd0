// MJCF, the model file of MuJoCo (https://mujoco.readthedocs.io/en/stable/XMLreference.html), ready to load and step.
#pragma once
#include "plico/io/motion/robot.h"

namespace plico {

// One body a panel, nested along the tree, the stationary panel of each part fixed to the world; a hinge joint whose
// angle is the fold angle and a position actuator on it; hinges that close loops as pairs of `connect` constraints;
// one keyframe a waypoint (qpos and ctrl), so the keyframes are the path. Panels that share a corner, flat or glued,
// do not collide. Non-convex panels collide as their convex hull, as all meshes do in MuJoCo. There is no gravity: the
// question is how the sheet moves, not how strong its hinges are. Warns of chains deeper than kDeepChain.
RobotFile write_mjcf(const Linkage& linkage, const FoldingPath& path, const RobotOptions& options = {});

}  // namespace plico
