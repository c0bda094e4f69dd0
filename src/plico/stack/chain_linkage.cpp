#include "plico/stack/chain_linkage.h"

#include <utility>

#include "plico/base/error.h"

namespace plico {
namespace {

Vec3 direction(Heading heading) {
  const int step = index(heading) < 2 ? 1 : -1;
  return along_x(heading) ? Vec3(step, 0, 0) : Vec3(0, step, 0);
}

std::vector<Vec3> square_at(const Vec3& centre, double half) {
  return {centre + Vec3(-half, -half, 0), centre + Vec3(half, -half, 0), centre + Vec3(half, half, 0),
          centre + Vec3(-half, half, 0)};
}

}  // namespace

Linkage chain_linkage(const Headings& headings, const std::vector<double>& angles, const ChainShape& shape) {
  if (headings.size() != angles.size())
    throw InvalidInput("stack/angles", fmt::format("{} angles for {} hinges", angles.size(), headings.size()));
  Linkage chain;
  const double half = shape.side / 2;
  Vec3 centre = Vec3::Zero();
  for (int i = 0; i <= static_cast<int>(headings.size()); ++i) {
    chain.panels.push_back(square_at(centre, half));
    chain.order.push_back(i);
    chain.parent_panel.push_back(i - 1);
    chain.parent_hinge.push_back(i - 1);
    if (i == static_cast<int>(headings.size())) break;
    // The panel behind lies to the left of the axis.
    const Vec3 ahead = direction(headings[i]), left = direction(turned(headings[i], 1));
    const Vec3 middle = centre + half * ahead;
    chain.hinges.push_back({i, i + 1, middle - half * left, middle + half * left, angles[i]});
    centre += shape.side * ahead;
  }
  return thick_hinged(std::move(chain), shape.thickness, shape.trim);
}

}  // namespace plico
