// Which panel lies on which where a folded sheet is flat in places: what poses alone do not tell.
#pragma once
#include <vector>

#include "plico/motion/plates.h"

namespace plico {

// Two plates in one plane that cover each other, of panels without a common hinge (a hinge's angle tells its order).
struct LayerPair {
  int a, b;    // plates, a < b
  Vec3 point;  // of b, flat state: in the middle of what both cover
};

class Layers {
 public:
  explicit Layers(const Linkage& linkage, double clearance);  // the linkage must outlive it

  // O(plates^2).
  std::vector<LayerPair> stacked(const Configuration& config) const;
  // On which side of a the point of b is: +1 the front, -1 the back, 0 still on it.
  std::vector<signed char> sides(const std::vector<LayerPair>& pairs, const Configuration& config) const;

 private:
  const Linkage& linkage_;
  Plates plates_;
  std::vector<std::vector<int>> neighbours_;  // panels, of each panel
  double flat_;                               // closer is on it, units
};

}  // namespace plico
