// Which panels of a linkage penetrate each other at a configuration.
//
// Panels are plates, thin or prisms, shrunk by a clearance (motion/plates.h), so that neighbours, panels around a
// common vertex and sides that close at the goal are not false alarms. Penetration is forbidden, touching is allowed,
// and panels that lie on each other in one plane (folds of 180 degrees) touch. Two panels at a hinge collide only when
// it is turned beyond 180 degrees, unless one of them reaches across the line of the hinge; thick ones are looked at
// like any two, since where the axis lies in their thickness decides. Panels of different parts never collide: each
// part folds by itself.
#pragma once
#include <compare>
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/motion/plates.h"

namespace plico {

struct CollisionOptions {
  double clearance = 0;  // how far every side of a panel moves inward, units; 0: 1e-3 of the mean side length
  double touch = 0;      // deepest penetration that still is a touch, units; 0: 1e-3 of the clearance
};

struct PanelPair {
  int a = -1, b = -1;  // a < b
  auto operator<=>(const PanelPair&) const = default;
};

// Answers for one linkage, one state after the other. Remembers what the last state taught it (the pair that collided,
// the order of the boxes), which changes the time an answer takes but never the answer. One thread at a time; the
// linkage must outlive it.
class CollisionChecker {
 public:
  explicit CollisionChecker(const Linkage& linkage, const CollisionOptions& options = {});

  // Stops at the first pair found. O(panels log panels) while each panel is near few others.
  bool collides(const Configuration& config);
  // All pairs, ascending.
  std::vector<PanelPair> collisions(const Configuration& config);

  double clearance() const { return clearance_; }
  double touch() const { return touch_; }

 private:
  struct Box {
    double low[3], high[3];
  };
  void find_exempt_pairs();
  void place(const Configuration& config);
  void sort_boxes();
  bool over_folded(const Configuration& config, std::vector<PanelPair>* all) const;
  bool may_collide(int plate_a, int plate_b) const;
  bool penetrating(int plate_a, int plate_b);
  template <class Visit>
  bool sweep(Visit visit);  // visit(plate, plate) for pairs whose boxes meet, until it returns true

  const Linkage& linkage_;
  double clearance_, touch_;
  Plates plates_;
  std::vector<int> part_;
  std::vector<std::vector<int>> exempt_;  // of each panel: neighbours that its hinge keeps apart
  std::vector<Pose> poses_;
  std::vector<Vec3> corners_, normals_;  // placed
  std::vector<Box> boxes_, sorted_;
  std::vector<int> order_;
  int axis_ = -1;
  int last_a_ = -1, last_b_ = -1;  // plates that collided last
};

}  // namespace plico
