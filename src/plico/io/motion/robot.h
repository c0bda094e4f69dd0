// What URDF and MJCF share: mass and inertia of panels, and the range each hinge needs.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/folding_path.h"

namespace plico {

struct RobotOptions {
  std::string name = "sheet";      // of the robot; letters, digits, "_" and "-"
  double metres_per_unit = 0.001;  // the default reads the linkage's unit as millimetres
  double grams_per_square_metre = 160;
  double sheet_thickness_mm = 0.2;  // of panels whose linkage says 0
  double seconds = 4;               // from flat to folded
};
void check(const RobotOptions& options);  // throws InvalidOption naming field, value and range

struct RobotFile {
  std::string text;
  std::vector<std::string> warnings;  // what a simulator may stumble over
};

// A homogeneous plate in SI units, seen from the origin of the panel's frame.
struct PanelBody {
  double mass = 0;  // kg
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre; positive definite
};
PanelBody panel_body(const Linkage& linkage, int panel, const Vec3& origin, const RobotOptions& options);

double plate_thickness(const Linkage& linkage, const RobotOptions& options);  // metres

// Newton metres that the hinge of each panel to its parent needs: twice what holds all that hangs on it against
// gravity, stretched out flat. 0 for roots. O(panels * chain depth).
std::vector<double> hinge_efforts(const Linkage& linkage, const RobotOptions& options);

// From flat to goal, as far as the limits of the hinge allow, and wherever the path goes, radians.
struct AngleRange {
  double low = 0, high = 0;
};
std::vector<AngleRange> angle_ranges(const Linkage& linkage, const FoldingPath& path);

// Shortest text of about seven digits, for coordinates in files that programs read as float or double.
std::string robot_numbers(const Vec3& v);

}  // namespace plico
