// A body as the smooth union of tapered limbs, given by a function that is negative inside. Polynomial smooth minimum.
#pragma once
#include <limits>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// A segment with a ball at each end and everything between them; flattened along `across` (a direction that is made
// perpendicular to the segment) to `thickness` times its width.
struct Limb {
  Vec3 from, to;
  double from_radius, to_radius;  // units
  double blend = 0.05;            // width of the seam to the limbs before it, units
  Vec3 across = Vec3::UnitZ();
  double thickness = 1;  // in (0, 1]
};

class SmoothBody {
 public:
  explicit SmoothBody(const std::vector<Limb>& limbs);

  double value(const Vec3& p) const;                // negative inside; O(limbs)
  double steepness() const { return steepness_; }   // |value(p) - value(q)| <= steepness |p - q|
  double thinnest() const { return thinnest_; }     // smallest half thickness of a limb, units
  Eigen::AlignedBox3d box() const { return box_; }  // holds the body

 private:
  struct Part {
    Vec3 from, along, across;
    double per_length2, from_radius, taper, stretch, blend;
    double value(const Vec3& p) const;
  };
  std::vector<Part> parts_;
  double steepness_ = 1, thinnest_ = std::numeric_limits<double>::max();
  Eigen::AlignedBox3d box_;
};

}  // namespace plico
