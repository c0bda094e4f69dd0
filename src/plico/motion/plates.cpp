#include "plico/motion/plates.h"

#include <cmath>

#include "plico/base/error.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

// No corner moves by more than this many clearances: a sharp tip must not lose more than a blunt one.
constexpr double kLongestMitre = 4;

std::vector<Vec2> offset_inward(const std::vector<Vec2>& outline, double distance) {
  const std::size_t n = outline.size();
  std::vector<Vec2> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = perpendicular(outline[i] - outline[(i + n - 1) % n]).normalized();
    const Vec2 after = perpendicular(outline[(i + 1) % n] - outline[i]).normalized();
    Vec2 mitre = (before + after) / std::max(1 + before.dot(after), 1e-12);
    if (mitre.norm() > kLongestMitre) mitre *= kLongestMitre / mitre.norm();
    result[i] = outline[i] + distance * mitre;
  }
  return result;
}

bool keeps_its_sides(const std::vector<Vec2>& outline, const std::vector<Vec2>& shrunk) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 side = outline[(i + 1) % n] - outline[i], now = shrunk[(i + 1) % n] - shrunk[i];
    if (!(side.dot(now) >= 0.5 * side.squaredNorm())) return false;
  }
  return true;
}

std::vector<Vec2> shrink(const std::vector<Vec2>& outline, double clearance) {
  for (double distance = clearance; distance > 1e-9 * clearance; distance /= 2) {
    std::vector<Vec2> shrunk = offset_inward(outline, distance);
    if (keeps_its_sides(outline, shrunk)) return shrunk;
  }
  return outline;
}

void add_plate(Plates& plates, int panel, const std::vector<Vec2>& corners, double thickness) {
  const auto add = [&](double z) {
    for (const Vec2& p : corners) plates.corners.push_back({p.x(), p.y(), z});
  };
  add(-thickness / 2);
  if (plates.are_thick) add(thickness / 2);
  plates.first.push_back(static_cast<int>(plates.corners.size()));
  plates.panel.push_back(panel);
}

}  // namespace

Plates make_plates(const Linkage& linkage, double clearance) {
  if (!(clearance >= 0) || !std::isfinite(clearance))
    throw InvalidOption(fmt::format("clearance = {} must be a finite length, at least 0", clearance));
  Plates plates;
  plates.are_thick = linkage.thickness > 0;
  for (int p = 0; p < linkage.num_panels(); ++p) {
    std::vector<Vec2> outline;
    for (const Vec3& corner : linkage.panels[p]) outline.push_back(corner.head<2>());
    outline = shrink(outline, clearance);
    if (is_convex(outline)) {
      add_plate(plates, p, outline, linkage.thickness);
    } else {
      for (const auto& [a, b, c] : triangulate(outline))
        add_plate(plates, p, {outline[a], outline[b], outline[c]}, linkage.thickness);
    }
    plates.first_of_panel.push_back(plates.size());
  }
  return plates;
}

}  // namespace plico
