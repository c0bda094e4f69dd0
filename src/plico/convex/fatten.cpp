#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/convex/remesh_steps.h"

namespace plico {
namespace {

// The plane through two neighbouring points of the loop that touches `inside` from above, on the side of a third point.
// Source: the same for the first point of a gift wrap.
Plane touching_plane(const Vec3& p, const Vec3& q, const Vec3& beside, std::span<const Vec3> inside, double tolerance) {
  const Vec3 along = (q - p).normalized();
  Vec3 across = beside - p;
  across = (across - along.dot(across) * along).normalized();
  const Vec3 up = along.cross(across);  // outward: p, q, beside are counter-clockwise
  // The steepest point seen from the line is the one that all others lie below.
  Vec2 steepest(0, -1);
  for (const Vec3& o : inside) {
    const Vec2 seen(across.dot(o - p), up.dot(o - p));
    if (seen.norm() <= tolerance) continue;
    if (steepest.x() * seen.y() - steepest.y() * seen.x() > 0) steepest = seen;
  }
  const Vec3 normal = (steepest.x() * up - steepest.y() * across).normalized();
  return {normal, normal.dot(p)};
}

class Fattening {
 public:
  Fattening(ShellSurface& surface, std::span<const Vec3> inside, RemeshBudget& budget)
      : surface_(surface), inside_(inside), budget_(budget), fat_(fat_sum(surface)) {}

  bool move(int v) {
    const auto patch = surface_.patch_of(v);
    if (!patch) return false;
    const Vec3 here = surface_.point(v);
    const FatSum rest = fat_ - fan_sum(surface_, *patch, here);
    const std::vector<Plane> below = limits(*patch, here), flats = surface_.flats(*patch);
    Vec3 best = here;
    double best_share = fat_.share() * (1 + 1e-9);
    for (const Vec3& target : targets(*patch, here)) {
      ++budget_.solves;
      const auto point = closest_point({below, flats}, target, 4 * (target - here).norm() + surface_.room().margin);
      if (!point) continue;
      const double share = (rest + fan_sum(surface_, *patch, *point)).share();
      if (share <= best_share || surface_.gain(*patch, *point) > budget_.volume || !holds(*patch, *point)) continue;
      best = *point;
      best_share = share;
    }
    if (best == here) return false;
    budget_.volume -= surface_.gain(*patch, best);
    fat_ = rest + fan_sum(surface_, *patch, best);
    surface_.replace(*patch, best);
    return true;
  }

 private:
  std::vector<Plane> limits(const ShellSurface::Patch& patch, const Vec3& here) const {
    std::vector<Plane> below = surface_.limits(patch);
    surface_.add_spokes(patch, below);
    const std::vector<Plane> flats = surface_.flats(patch);
    for (std::size_t i = 0; i < patch.loop.size(); ++i) {
      const Vec3 &p = surface_.point(patch.loop[i]), &q = surface_.point(patch.loop[(i + 1) % patch.loop.size()]);
      const double tolerance = surface_.room().tolerance;
      const bool flat = std::any_of(flats.begin(), flats.end(), [&](const Plane& plane) {
        return std::max(std::abs(plane.height(p)), std::abs(plane.height(q))) <= tolerance;
      });
      if (flat) continue;
      const Plane plane = touching_plane(p, q, here, inside_, tolerance).flipped();
      below.push_back({plane.normal, plane.offset - surface_.room().margin / 8});
    }
    // The volume that is left.
    const Vec3 uphill = surface_.uphill(patch);
    const double slope = uphill.norm();
    if (slope > 0) below.push_back({uphill / slope, uphill.dot(here) / slope + 3 * budget_.volume / slope});
    return below;
  }

  // Like is_allowed(), but the point that moves may go inward, down to what the surface must hold.
  bool holds(const ShellSurface::Patch& patch, const Vec3& point) const {
    ShellSurface::Patch moved = patch;
    moved.removed = {-1, -1};
    if (!surface_.is_allowed(moved, point)) return false;
    for (std::size_t i = 0; i < patch.loop.size(); ++i) {
      const Vec3 &p = surface_.point(patch.loop[i]), &q = surface_.point(patch.loop[(i + 1) % patch.loop.size()]);
      const Vec3 normal = (q - p).cross(point - p).normalized();
      for (const Vec3& o : inside_)
        if (normal.dot(o - p) > surface_.room().tolerance / 4) return false;
    }
    return true;
  }

  // The mean of the neighbours, and steps of several lengths towards fatter triangles.
  std::vector<Vec3> targets(const ShellSurface::Patch& patch, const Vec3& here) const {
    Vec3 mean = Vec3::Zero();
    for (int v : patch.loop) mean += surface_.point(v) / static_cast<double>(patch.loop.size());
    double reach = 0;
    for (int v : patch.loop) reach += (surface_.point(v) - here).norm() / static_cast<double>(patch.loop.size());
    std::vector<Vec3> result = {mean, (mean + here) / 2, here + (mean - here) / 8};
    const Vec3 way = steepest(patch, here, 1e-4 * reach);
    for (double length : {0.5, 0.2, 0.07, 0.02, 0.005})
      if (way.norm() > 0) result.emplace_back(here + length * reach * way);
    return result;
  }

  // Direction in which the share of fat rises fastest.
  Vec3 steepest(const ShellSurface::Patch& patch, const Vec3& here, double step) const {
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      const FatSum change = fan_sum(surface_, patch, here + step * Vec3::Unit(axis)) -
                            fan_sum(surface_, patch, here - step * Vec3::Unit(axis));
      slope[axis] = change.fat - fat_.share() * change.area;
    }
    const double length = slope.norm();
    return length > 0 ? Vec3(slope / length) : Vec3(Vec3::Zero());
  }

  ShellSurface& surface_;
  std::span<const Vec3> inside_;
  RemeshBudget& budget_;
  FatSum fat_;
};

}  // namespace

bool fatten_once(ShellSurface& surface, std::span<const Vec3> inside, RemeshBudget& budget) {
  Fattening fattening(surface, inside, budget);
  bool moved = false;
  for (int v = 0; v < surface.num_vertices(); ++v)
    if (surface.is_alive(v)) moved |= fattening.move(v);
  return moved;
}

}  // namespace plico
