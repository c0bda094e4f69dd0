#include "plico/io/motion/robot.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "plico/base/error.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

void check_positive(const char* field, double value) {
  if (!(value > 0)) throw InvalidOption(fmt::format("{} = {} must be above 0", field, value));
}

// Integrals of x^2, y^2 and xy over a polygon, about the origin: Green's theorem, one term a side.
struct SecondMoments {
  double xx = 0, yy = 0, xy = 0;
};
SecondMoments second_moments(const std::vector<Vec2>& polygon) {
  SecondMoments m;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double c = cross(a, b);
    m.xx += c * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 12;
    m.yy += c * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 12;
    m.xy += c * (a.x() * b.y() + 2 * a.x() * a.y() + 2 * b.x() * b.y() + b.x() * a.y()) / 24;
  }
  return m;
}

}  // namespace

void check(const RobotOptions& options) {
  check_positive("metres_per_unit", options.metres_per_unit);
  check_positive("grams_per_square_metre", options.grams_per_square_metre);
  check_positive("sheet_thickness_mm", options.sheet_thickness_mm);
  check_positive("seconds", options.seconds);
  const bool plain = std::all_of(options.name.begin(), options.name.end(),
                                 [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (options.name.empty() || !plain)
    throw InvalidOption(fmt::format("name = '{}' must be letters, digits, '_' or '-'", options.name));
}

double plate_thickness(const Linkage& linkage, const RobotOptions& options) {
  return linkage.thickness > 0 ? linkage.thickness * options.metres_per_unit : options.sheet_thickness_mm / 1000;
}

PanelBody panel_body(const Linkage& linkage, int panel, const Vec3& origin, const RobotOptions& options) {
  std::vector<Vec2> outline;
  for (const Vec3& p : linkage.panels[panel]) outline.push_back((p - origin).head<2>() * options.metres_per_unit);
  const double area = signed_area(outline);
  if (!(area > 0)) throw InvalidInput("linkage/panel-area", fmt::format("panel {} has no area, so no mass", panel));
  const Vec2 centre = centroid(outline);
  for (Vec2& p : outline) p -= centre;
  const SecondMoments m = second_moments(outline);
  PanelBody body;
  body.mass = area * options.grams_per_square_metre / 1000;
  body.centre = Vec3(centre.x(), centre.y(), -origin.z() * options.metres_per_unit);
  // The thickness keeps the tensor of a needle-like panel away from singular.
  const double t = plate_thickness(linkage, options), across = body.mass * t * t / 12, density = body.mass / area;
  body.inertia(0, 0) = density * m.yy + across;
  body.inertia(1, 1) = density * m.xx + across;
  body.inertia(2, 2) = density * (m.xx + m.yy);
  body.inertia(0, 1) = body.inertia(1, 0) = -density * m.xy;
  return body;
}

std::vector<double> hinge_efforts(const Linkage& linkage, const RobotOptions& options) {
  constexpr double kGravity = 9.81, kSpare = 2;
  std::vector<double> effort(linkage.num_panels(), 0);
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const PanelBody body = panel_body(linkage, p, Vec3::Zero(), options);
    for (int at = p; linkage.parent_hinge[at] >= 0; at = linkage.parent_panel[at]) {
      const Hinge& hinge = linkage.hinges[linkage.parent_hinge[at]];
      const Vec2 from = hinge.from.head<2>() * options.metres_per_unit;
      const Vec2 along = (hinge.to - hinge.from).head<2>().normalized();
      const double lever = std::abs(cross(along, Vec2(body.centre.head<2>() - from)));
      effort[at] += kSpare * kGravity * body.mass * lever;
    }
  }
  return effort;
}

std::vector<AngleRange> angle_ranges(const Linkage& linkage, const FoldingPath& path) {
  std::vector<AngleRange> ranges(linkage.hinges.size());
  const auto include = [&](const Configuration& config) {
    for (int h = 0; h < config.size(); ++h) {
      ranges[h].low = std::min(ranges[h].low, config[h]);
      ranges[h].high = std::max(ranges[h].high, config[h]);
    }
  };
  include(goal(linkage).cwiseMax(lower_limits(linkage)).cwiseMin(upper_limits(linkage)));
  for (const Waypoint& waypoint : path.waypoints) include(waypoint.config);
  return ranges;
}

std::string robot_numbers(const Vec3& v) {
  return fmt::format("{:.7g} {:.7g} {:.7g}", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

}  // namespace plico
