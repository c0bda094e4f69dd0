#include "plico/io/motion/urdf.h"

#include "plico/base/error.h"
#include "plico/geom/convex2.h"
#include "plico/io/motion/panel_joints.h"

namespace plico {
namespace {

// The smallest plate around a panel, in the panel's frame, metres.
struct Plate {
  Vec3 centre, size;
  double angle = 0;  // about z
};
Plate plate_around(const Linkage& linkage, int panel, const Vec3& origin, const RobotOptions& options) {
  std::vector<Vec2> outline;
  for (const Vec3& p : linkage.panels[panel]) outline.push_back((p - origin).head<2>() * options.metres_per_unit);
  const TurnedRectangle rectangle = least_area_rectangle(convex_hull(outline));
  const Eigen::Matrix2d turn = rotation(rectangle.angle);
  Vec2 low = turn.inverse() * outline.front(), high = low;
  for (const Vec2& p : outline) {
    const Vec2 q = turn.inverse() * p;
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Vec2 centre = turn * Vec2((low + high) / 2), size = high - low;
  return {{centre.x(), centre.y(), -origin.z() * options.metres_per_unit},
          {size.x(), size.y(), plate_thickness(linkage, options)},
          rectangle.angle};
}

std::string link(const Linkage& linkage, int panel, const PanelJoint& joint, const RobotOptions& options) {
  const PanelBody body = panel_body(linkage, panel, joint.origin, options);
  const Plate plate = plate_around(linkage, panel, joint.origin, options);
  const std::string shape =
      fmt::format("<origin xyz=\"{}\" rpy=\"0 0 {:.7g}\"/><geometry><box size=\"{}\"/></geometry>",
                  robot_numbers(plate.centre), plate.angle, robot_numbers(plate.size));
  const auto& i = body.inertia;
  return fmt::format(
      "  <link name=\"panel_{}\">\n"
      "    <inertial><origin xyz=\"{}\"/><mass value=\"{:.7g}\"/>\n"
      "      <inertia ixx=\"{:.7g}\" ixy=\"{:.7g}\" ixz=\"0\" iyy=\"{:.7g}\" iyz=\"0\" izz=\"{:.7g}\"/></inertial>\n"
      "    <visual>{}<material name=\"front\"/></visual>\n    <collision>{}</collision>\n  </link>\n",
      panel, robot_numbers(body.centre), body.mass, i(0, 0), i(0, 1) + 0.0, i(1, 1), i(2, 2), shape, shape);
}

std::string joint_text(int panel, const PanelJoint& joint, const AngleRange& range, double effort,
                       const RobotOptions& options) {
  return fmt::format(
      "  <joint name=\"hinge_{}\" type=\"revolute\">\n    <parent link=\"panel_{}\"/><child link=\"panel_{}\"/>\n"
      "    <origin xyz=\"{}\"/><axis xyz=\"{}\"/>\n"
      "    <limit lower=\"{:.7g}\" upper=\"{:.7g}\" effort=\"{:.7g}\" velocity=\"{:.7g}\"/>\n  </joint>\n",
      joint.hinge, joint.parent, panel, robot_numbers(joint.offset * options.metres_per_unit),
      robot_numbers(joint.axis), range.low + 0.0, range.high + 0.0, effort, 10 * kPi / options.seconds);
}

std::string fixed_joint(int panel) {
  return fmt::format(
      "  <joint name=\"part_{0}\" type=\"fixed\"><parent link=\"base\"/><child link=\"panel_{0}\"/></joint>\n", panel);
}

}  // namespace

RobotFile write_urdf(const Linkage& linkage, const FoldingPath& path, const RobotOptions& options) {
  check(options);
  require_within_limits(linkage, path);
  const std::vector<PanelJoint> joints = panel_joints(linkage);
  const std::vector<AngleRange> ranges = angle_ranges(linkage, path);
  const std::vector<double> efforts = hinge_efforts(linkage, options);
  RobotFile file;
  file.warnings = chain_warnings(linkage);
  if (linkage.has_loops())
    file.warnings.push_back(fmt::format("URDF holds trees only: {} of {} hinges close loops and are left out",
                                        linkage.loop_hinges.size(), linkage.num_hinges()));
  int num_roots = 0;
  for (const PanelJoint& joint : joints) num_roots += joint.parent < 0;
  std::string& xml = file.text;
  xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <material name=\"front\"><color rgba=\"0.94 0.72 0.31 1\"/>"
      "</material>\n",
      options.name);
  if (num_roots > 1) xml += "  <link name=\"base\"/>\n";
  for (int p : linkage.order) xml += link(linkage, p, joints[p], options);
  for (int p : linkage.order) {
    if (joints[p].parent >= 0)
      xml += joint_text(p, joints[p], ranges[joints[p].hinge], efforts[p], options);
    else if (num_roots > 1)
      xml += fixed_joint(p);
  }
  xml += "</robot>\n";
  return file;
}

}  // namespace plico
