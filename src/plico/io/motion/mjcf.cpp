#include "plico/io/motion/mjcf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "plico/base/error.h"
#include "plico/io/motion/panel_joints.h"
#include "plico/io/motion/panel_solid.h"

namespace plico {
namespace {

// Sets of corners that are one point of the folded shape: equal in the sheet, or glued.
class Corners {
 public:
  explicit Corners(const Linkage& linkage) {
    std::map<std::tuple<double, double, double>, int> known;
    double size = 0;
    for (const auto& panel : linkage.panels)
      for (const Vec3& p : panel) size = std::max(size, p.cwiseAbs().maxCoeff());
    const double grid = std::max(size, 1e-300) * 1e-8;  // corners laid flat along two ways differ by rounding
    for (const auto& panel : linkage.panels) {
      std::vector<int>& ids = corner_.emplace_back();
      for (const Vec3& p : panel) {
        const auto cell = [&](int axis) { return std::round(p[axis] / grid); };
        ids.push_back(known.try_emplace({cell(0), cell(1), cell(2)}, static_cast<int>(known.size())).first->second);
      }
    }
    leader_.resize(known.size());
    std::iota(leader_.begin(), leader_.end(), 0);
    for (const Linkage::Seam& seam : linkage.seams) {
      join(at(seam.panel_a, seam.side_a), at(seam.panel_b, seam.side_b + 1));
      join(at(seam.panel_a, seam.side_a + 1), at(seam.panel_b, seam.side_b));
    }
  }

  std::set<std::pair<int, int>> panels_that_touch() {
    std::map<int, std::set<int>> around;
    for (int p = 0; p < static_cast<int>(corner_.size()); ++p)
      for (int c : corner_[p]) around[find(c)].insert(p);
    std::set<std::pair<int, int>> pairs;
    for (const auto& [corner, panels] : around)
      for (int a : panels)
        for (int b : panels)
          if (a < b) pairs.insert({a, b});
    return pairs;
  }

 private:
  int at(int panel, int i) const { return corner_[panel][i % corner_[panel].size()]; }
  int find(int c) {
    while (leader_[c] != c) c = leader_[c] = leader_[leader_[c]];
    return c;
  }
  void join(int a, int b) { leader_[find(a)] = find(b); }

  std::vector<std::vector<int>> corner_;
  std::vector<int> leader_;
};

class MjcfWriter {
 public:
  MjcfWriter(const Linkage& linkage, const FoldingPath& path, const RobotOptions& options)
      : linkage_(linkage),
        path_(path),
        options_(options),
        joints_(panel_joints(linkage)),
        order_(depth_first(linkage, joints_)),
        ranges_(angle_ranges(linkage, path)) {}

  std::string write() {
    add_header();
    add_meshes();
    xml_ += "  <worldbody>\n    <light pos=\"0 0 3\" directional=\"true\"/>\n";
    add_bodies();
    xml_ += "  </worldbody>\n";
    add_exclusions();
    add_loops();
    add_actuators();
    add_keyframes();
    return xml_ + "</mujoco>\n";
  }

 private:
  // Share of the whole sheet's inertia that every joint carries besides its panels. It keeps the ratio between the
  // lightest and the heaviest thing a motor turns small, so that one gain fits all and the step stays stable.
  static constexpr double kMotorShare = 1;
  static constexpr double kMotorRate = 30;  // rad/s: how fast a motor follows its target

  // kg m^2, added to every panel: MuJoCo takes inertia below 1e-14 for zero, which panels of some millimetres have. The
  // motors carry a hundred times more at least.
  static constexpr double kLeastInertia = 1e-12;

  double motor_inertia() const {
    double mass = 0, reach = 0;
    for (int p : order_) {
      mass += panel_body(linkage_, p, Vec3::Zero(), options_).mass;
      for (const Vec3& v : linkage_.panels[p])
        reach = std::max(reach, (v - linkage_.panels[0][0]).norm() * options_.metres_per_unit);
    }
    return std::max(1e-10, kMotorShare * mass * reach * reach);
  }

  void add_header() {
    const double inertia = motor_inertia(), stiffness = inertia * kMotorRate * kMotorRate;
    xml_ = fmt::format(
        "<mujoco model=\"{}\">\n  <compiler angle=\"radian\" autolimits=\"true\"/>\n"
        "  <option timestep=\"0.002\" gravity=\"0 0 0\" integrator=\"implicitfast\"/>\n"
        "  <default>\n    <joint armature=\"{:.7g}\" damping=\"{:.7g}\"/>\n    <position kp=\"{:.7g}\"/>\n"
        "    <geom type=\"mesh\" rgba=\"0.94 0.72 0.31 1\"/>\n  </default>\n",
        options_.name, inertia, 2 * inertia * kMotorRate, stiffness);
  }

  // Plates as thick as the sheet: MuJoCo's meshes have a volume.
  void add_meshes() {
    Linkage plates = linkage_;
    plates.thickness = plate_thickness(linkage_, options_) / options_.metres_per_unit;
    xml_ += "  <asset>\n";
    for (int p : order_) {
      const PanelSolid solid = panel_solid(plates, p);
      xml_ += fmt::format("    <mesh name=\"panel_{}\" vertex=\"", p);
      for (const Vec3& v : solid.points) {
        if (xml_.back() != '"') xml_ += "  ";
        xml_ += robot_numbers((v - joints_[p].origin) * options_.metres_per_unit);
      }
      xml_ += "\" face=\"";
      for (const auto* triangles : {&solid.front, &solid.back, &solid.walls})
        for (const auto& [a, b, c] : *triangles) {
          if (xml_.back() != '"') xml_ += "  ";
          xml_ += fmt::format("{} {} {}", a, b, c);
        }
      xml_ += "\"/>\n";
    }
    xml_ += "  </asset>\n";
  }

  void add_bodies() {
    std::vector<int> open;  // the chain of bodies around the current one
    const auto close_to = [&](int parent) {
      while (!open.empty() && open.back() != parent) {
        open.pop_back();
        xml_ += std::string(2 * open.size() + 4, ' ') + "</body>\n";
      }
    };
    for (int p : order_) {
      close_to(joints_[p].parent);
      add_body(p, std::string(2 * open.size() + 4, ' '));
      open.push_back(p);
    }
    close_to(-1);
  }
  void add_body(int p, const std::string& indent) {
    const PanelJoint& joint = joints_[p];
    const PanelBody body = panel_body(linkage_, p, joint.origin, options_);
    const Eigen::Matrix3d i = body.inertia + kLeastInertia * Eigen::Matrix3d::Identity();
    xml_ += fmt::format("{}<body name=\"panel_{}\" pos=\"{}\">\n", indent, p,
                        robot_numbers(joint.offset * options_.metres_per_unit));
    xml_ += fmt::format("{}  <inertial pos=\"{}\" mass=\"{:.7g}\" fullinertia=\"{:.7g} {:.7g} {:.7g} {:.7g} 0 0\"/>\n",
                        indent, robot_numbers(body.centre), body.mass, i(0, 0), i(1, 1), i(2, 2), i(0, 1) + 0.0);
    if (joint.parent >= 0)
      xml_ += fmt::format("{}  <joint name=\"hinge_{}\" axis=\"{}\" range=\"{}\"/>\n", indent, joint.hinge,
                          robot_numbers(joint.axis), range(joint.hinge));
    xml_ += fmt::format("{0}  <geom mesh=\"panel_{1}\"/>\n", indent, p);
  }
  // A hinge that never moves still needs a range: MuJoCo wants low < high.
  std::string range(int hinge) const {
    const AngleRange r = ranges_[hinge];
    return fmt::format("{:.7g} {:.7g}", r.low + 0.0, std::max(r.high, r.low + 1e-4));
  }

  void add_exclusions() {
    const auto pairs = Corners(linkage_).panels_that_touch();
    if (pairs.empty()) return;
    xml_ += "  <contact>\n";
    for (const auto& [a, b] : pairs)
      xml_ += fmt::format("    <exclude body1=\"panel_{}\" body2=\"panel_{}\"/>\n", a, b);
    xml_ += "  </contact>\n";
  }

  // Two points of a line held together are a hinge.
  void add_loops() {
    if (!linkage_.has_loops()) return;
    xml_ += "  <equality>\n";
    for (int h : linkage_.loop_hinges) {
      const Hinge& hinge = linkage_.hinges[h];
      for (const Vec3& point : {hinge.from, hinge.to})
        xml_ +=
            fmt::format("    <connect body1=\"panel_{}\" body2=\"panel_{}\" anchor=\"{}\"/>\n", hinge.left, hinge.right,
                        robot_numbers((point - joints_[hinge.left].origin) * options_.metres_per_unit));
    }
    xml_ += "  </equality>\n";
  }

  // Joints in the order in which MuJoCo numbers them.
  std::vector<int> hinges_in_order() const {
    std::vector<int> hinges;
    for (int p : order_)
      if (joints_[p].hinge >= 0) hinges.push_back(joints_[p].hinge);
    return hinges;
  }

  void add_actuators() {
    const std::vector<int> hinges = hinges_in_order();
    if (hinges.empty()) return;
    xml_ += "  <actuator>\n";
    for (int h : hinges)
      xml_ += fmt::format("    <position name=\"fold_{0}\" joint=\"hinge_{0}\" ctrlrange=\"{1}\"/>\n", h, range(h));
    xml_ += "  </actuator>\n";
  }

  void add_keyframes() {
    const std::vector<int> hinges = hinges_in_order();
    if (hinges.empty()) return;
    xml_ += "  <keyframe>\n";
    for (std::size_t k = 0; k < path_.waypoints.size(); ++k) {
      std::string angles;
      for (int h : hinges)
        angles += fmt::format("{}{:.7g}", angles.empty() ? "" : " ", path_.waypoints[k].config[h] + 0.0);
      xml_ += fmt::format("    <key name=\"waypoint_{}\" time=\"{:.7g}\" qpos=\"{}\" ctrl=\"{}\"/>\n", k,
                          path_.waypoints[k].time * options_.seconds, angles, angles);
    }
    xml_ += "  </keyframe>\n";
  }

  const Linkage& linkage_;
  const FoldingPath& path_;
  const RobotOptions& options_;
  const std::vector<PanelJoint> joints_;
  const std::vector<int> order_;  // depth first: MuJoCo numbers joints so
  const std::vector<AngleRange> ranges_;
  std::string xml_;
};

}  // namespace

RobotFile write_mjcf(const Linkage& linkage, const FoldingPath& path, const RobotOptions& options) {
  check(options);
  if (linkage.num_panels() == 0) throw InvalidInput("linkage/empty", "a linkage without panels has no bodies");
  require_within_limits(linkage, path);
  return {MjcfWriter(linkage, path, options).write(), chain_warnings(linkage)};
}

}  // namespace plico
