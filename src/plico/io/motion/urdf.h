// URDF, the robot description of ROS: one link a panel, one revolute joint a fold whose angle is the fold angle.
#pragma once
#include "plico/io/motion/robot.h"

namespace plico {

// The stationary panel is the root link; parts are fixed to a link "base" when there are several. URDF knows boxes but
// no polygons, so a panel looks like the smallest plate around it; mass and inertia are the panel's own. Joint limits
// run from flat to the goal and wherever `path` goes. Warns of chains deeper than kDeepChain, and of hinges that close
// loops: a tree cannot hold them (write_mjcf can). Joints are "hinge_0" ..., links "panel_0" ...
RobotFile write_urdf(const Linkage& linkage, const FoldingPath& path, const RobotOptions& options = {});

}  // namespace plico
