#include "plico/shapes/smooth_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plico {

SmoothBody::SmoothBody(const std::vector<Limb>& limbs) {
  for (const Limb& limb : limbs) {
    const Vec3 along = limb.to - limb.from;
    const double length2 = along.squaredNorm();
    Vec3 across = limb.across;
    if (length2 > 0) across -= along * (along.dot(across) / length2);
    const double taper = limb.to_radius - limb.from_radius;
    parts_.push_back({limb.from, along, across.normalized(), length2 > 0 ? 1 / length2 : 0, limb.from_radius, taper,
                      1 / limb.thickness - 1, limb.blend});
    const double slope = length2 > 0 ? std::abs(taper) / std::sqrt(length2) : 0;
    steepness_ = std::max(steepness_, (1 + slope) / limb.thickness);
    thinnest_ = std::min(thinnest_, std::min(limb.from_radius, limb.to_radius) * limb.thickness);
    // A seam swells by at most a quarter of its width for each limb that meets there.
    const double reach = std::max(limb.from_radius, limb.to_radius) + limb.blend;
    for (const Vec3& end : {limb.from, limb.to}) {
      box_.extend(end - Vec3::Constant(reach));
      box_.extend(end + Vec3::Constant(reach));
    }
  }
}

double SmoothBody::Part::value(const Vec3& p) const {
  Vec3 d = p - from;
  d += across * (across.dot(d) * stretch);
  const double t = std::clamp(d.dot(along) * per_length2, 0.0, 1.0);
  return (d - t * along).norm() - (from_radius + t * taper);
}

double SmoothBody::value(const Vec3& p) const {
  double united = std::numeric_limits<double>::max();
  for (const Part& part : parts_) {
    const double own = part.value(p), seam = std::max(part.blend - std::abs(own - united), 0.0);
    united = std::min(own, united) - seam * seam / (4 * part.blend);
  }
  return united;
}

}  // namespace plico
