// The bodies of one step of a peel, and whether they keep clear of what stands and of each other.
#pragma once
#include <array>
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/geom/oriented_box.h"

namespace plico {

using Angles3 = std::array<double, 3>;  // of the hinges of a step; those beyond its count are 0

// The chain as boxes: where every panel stands in the shape, and the tower of all that follow one.
class PeelBodies {
 public:
  PeelBodies(const Linkage& chain, int sign, double air);

  int num_panels() const { return static_cast<int>(standing_.size()); }
  const Hinge& hinge(int h) const { return chain_.hinges[h]; }
  const OrientedBox& standing(int panel) const { return standing_[panel]; }
  const Pose& pose(int panel) const { return pose_[panel]; }
  double pile_angle(int h) const { return (h % 2 ? -sign_ : sign_) * kPi; }
  double radius() const { return radius_; }  // of the sphere around a panel

  OrientedBox panel(int p) const;              // flat, as the linkage has it
  OrientedBox tower(int first, int on) const;  // the panels from `first` on, piled upon panel `on`; flat as panel `on`

 private:
  const Linkage& chain_;
  double sign_, half_side_, half_thickness_, air_, radius_;
  std::vector<Pose> pose_;
  std::vector<OrientedBox> standing_;
};

class PeelWindow {
 public:
  // Opens the hinges first .. first + count - 1; panels 0 .. first stand.
  PeelWindow(const PeelBodies& bodies, int first, int count);

  int first() const { return first_; }
  int count() const { return count_; }
  Angles3 start() const;  // in the pile
  Angles3 end() const;    // in the shape

  bool free_at(const Angles3& angles) const;
  // Every moment of the straight way between two states, by bisection: the gap of two boxes at the middle of an
  // interval against how far they can move within it. False also when that cannot be decided.
  bool free_between(const Angles3& from, const Angles3& to, long& intervals) const;

 private:
  // Moves with the first `depth` hinges of the step; `local` is flat.
  struct Body {
    int panel, depth;
    OrientedBox local;
  };
  // A standing panel (`other` < 0: -1 - panel) or another body against body `mover`.
  struct Pair {
    int mover, other;
  };
  struct Placed {
    std::array<OrientedBox, 5> box;
    std::array<Vec3, 3> axis, point;  // of the hinges, in the world
  };

  void place(const Angles3& angles, Placed& placed) const;
  const OrientedBox& other_box(const Pair& pair, const Placed& placed) const;
  double reach(const Pair& pair, const Placed& placed, const Angles3& half_turn) const;
  bool halve(const Angles3& from, const Angles3& to, const std::vector<Pair>& pairs, int depth, long& intervals) const;
  std::vector<Pair> near_pairs(const Placed& placed, double slack) const;

  const PeelBodies& bodies_;
  int first_, count_;
  std::vector<Body> movers_;
  std::vector<Pair> inner_;  // of movers among themselves, and with the panel they stand on
};

}  // namespace plico
