#include "plico/fold/plain_hinges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr double kQuarter = kPi / 2;
enum Axis { kFrontAxis, kBackAxis, kMiddleAxis };

double share_of(Axis axis, double angle) {
  switch (axis) {
    case kFrontAxis:
      return std::max(angle - kQuarter, 0.0);
    case kBackAxis:
      return std::min(angle + kQuarter, 0.0);
    case kMiddleAxis:
      break;
  }
  return std::clamp(angle, -kQuarter, kQuarter);
}

class PlainHinges {
 public:
  explicit PlainHinges(const Linkage& thick) : thick_(thick) {}

  Linkage build() {
    plain_.thickness = thick_.thickness;
    plain_.panels = thick_.panels;
    plain_.panels.resize(thick_.panels.size() + 2 * thick_.hinges.size());
    plain_.hinges.resize(3 * thick_.hinges.size());
    plain_.parent_panel.assign(plain_.panels.size(), -1);
    plain_.parent_hinge.assign(plain_.panels.size(), -1);
    for (int p : thick_.order) {
      if (thick_.parent_hinge[p] >= 0) add_hinge(p);
      plain_.order.push_back(p);
    }
    plain_.seams = thick_.seams;
    return std::move(plain_);
  }

 private:
  void add_hinge(int panel) {
    const int h = thick_.parent_hinge[panel], strip = thick_.num_panels() + 2 * h;
    const std::array<int, 4> row{thick_.parent_panel[panel], strip, strip + 1, panel};
    for (int k : {0, 1, 2}) {
      plain_.hinges[3 * h + k] = axis(h, static_cast<Axis>(k), row[k], row[k + 1]);
      plain_.parent_panel[row[k + 1]] = row[k];
      plain_.parent_hinge[row[k + 1]] = 3 * h + k;
    }
    for (int k : {0, 1}) {
      plain_.panels[strip + k] = strip_along(thick_.hinges[h]);
      plain_.order.push_back(strip + k);
    }
  }

  Hinge axis(int h, Axis which, int rest, int moving) const {
    const Hinge& thick = thick_.hinges[h];
    const bool right_moves = thick_.parent_panel[thick.right] == thick.left && thick_.parent_hinge[thick.right] == h;
    Hinge hinge = thick;
    hinge.roll = 0;
    hinge.left = right_moves ? rest : moving;
    hinge.right = right_moves ? moving : rest;
    hinge.edge = hinge.a = hinge.b = -1;
    hinge.target = share_of(which, thick.target);
    hinge.low = share_of(which, thick.low);
    hinge.high = share_of(which, thick.high);
    if (which == kMiddleAxis) return hinge;
    const Vec3 along = (thick.to - thick.from).normalized(), left(-along.y(), along.x(), 0);
    const Vec3 aside = right_moves ? left : Vec3(-left), up = (which == kFrontAxis ? 1 : -1) * Vec3::UnitZ();
    hinge.from += thick.roll * (aside + up);
    hinge.to += thick.roll * (aside + up);
    return hinge;
  }

  // Counter-clockwise seen from the front.
  std::vector<Vec3> strip_along(const Hinge& hinge) const {
    const Vec3 along = (hinge.to - hinge.from).normalized(), left(-along.y(), along.x(), 0);
    const Vec3 half = thick_.thickness / 4 * left;
    return {hinge.from - half, hinge.to - half, hinge.to + half, hinge.from + half};
  }

  const Linkage& thick_;
  Linkage plain_;
};

// The times in (from, to) at which a hinge passes +-90 degrees, ascending, each once.
std::vector<double> passing_times(const Waypoint& from, const Waypoint& to) {
  std::vector<double> times;
  for (int h = 0; h < from.config.size(); ++h)
    for (double quarter : {-kQuarter, kQuarter}) {
      const double a = from.config[h] - quarter, b = to.config[h] - quarter;
      if (a * b < 0) times.push_back(from.time + a / (a - b) * (to.time - from.time));
    }
  std::ranges::sort(times);
  // Times that differ by rounding are one: waypoints must be apart.
  const double least = 1e-12;
  std::vector<double> apart;
  for (double time : times)
    if (time > (apart.empty() ? from.time : apart.back()) + least && time < to.time - least) apart.push_back(time);
  return apart;
}

}  // namespace

bool has_thick_hinges(const Linkage& linkage) {
  return std::ranges::any_of(linkage.hinges, [](const Hinge& hinge) { return hinge.roll > 0; });
}

Linkage plain_hinged(const Linkage& linkage) {
  if (linkage.has_loops())
    throw InvalidInput("linkage/loops", "thick hinges that close a loop cannot be told as plain ones");
  return PlainHinges(linkage).build();
}

Configuration plain_angles(const Configuration& config) {
  Configuration plain(3 * config.size());
  for (int h = 0; h < config.size(); ++h)
    for (const Axis axis : {kFrontAxis, kBackAxis, kMiddleAxis}) plain[3 * h + axis] = share_of(axis, config[h]);
  return plain;
}

FoldingPath plain_path(const FoldingPath& path) {
  FoldingPath plain;
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Waypoint& at = path.waypoints[i];
    plain.waypoints.push_back({at.time, plain_angles(at.config)});
    if (i + 1 == path.waypoints.size()) break;
    const Waypoint& next = path.waypoints[i + 1];
    for (double time : passing_times(at, next)) {
      const double s = (time - at.time) / (next.time - at.time);
      plain.waypoints.push_back({time, plain_angles((1 - s) * at.config + s * next.config)});
    }
  }
  return plain;
}

}  // namespace plico
