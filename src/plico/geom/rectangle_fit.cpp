#include "plico/geom/rectangle_fit.h"

#include <algorithm>

#include "plico/base/libm.h"

namespace plico {
namespace {

Vec2 extent(std::span<const Vec2> hull, double angle) {
  const Eigen::Matrix2d turn = rotation(angle);
  Eigen::AlignedBox2d box;
  for (const Vec2& p : hull) box.extend(turn * p);
  return box.sizes();
}

// Calls visit(angle) until it says true.
template <class Visit>
void each_angle(std::span<const Vec2> hull, Visit visit) {
  if (visit(0.0)) return;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const double angle = -plico::atan2(side.y(), side.x());
    if (visit(angle) || visit(angle + kPi / 2)) return;
  }
  for (int i = 1; i < 36; ++i)
    if (visit(radians(5.0 * i))) return;
}

}  // namespace

std::optional<double> angle_that_fits(std::span<const Vec2> hull, const Vec2& room) {
  std::optional<double> found;
  each_angle(hull, [&](double angle) {
    const Vec2 size = extent(hull, angle);
    if (size.x() > room.x() || size.y() > room.y()) return false;
    found = angle;
    return true;
  });
  return found;
}

double largest_scale(std::span<const Vec2> hull, const Vec2& room) {
  double best = 0;
  each_angle(hull, [&](double angle) {
    best = std::max(best, (room.array() / extent(hull, angle).array()).minCoeff());
    return false;
  });
  return best;
}

}  // namespace plico
