// The chain of a peel as boxes: where every panel stands in the shape, and the tower of all that follow one.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/geom/oriented_box.h"

namespace plico {

// Spheres around runs of boxes, halved down to single ones. Boxes that follow each other are near each other in a
// chain, so this finds what is near without looking at all.
class RunTree {
 public:
  explicit RunTree(const std::vector<OrientedBox>& boxes);

  // Does `is_met` say yes to one of the boxes 0 .. last? Asked are those that may come nearer than `slack` to `box`.
  template <class Test>
  bool any_near(const OrientedBox& box, double slack, int last, const Test& is_met) const {
    return last >= 0 && any_below(0, 0, size_, box, slack, last, is_met);
  }

 private:
  struct Sphere {
    Vec3 center = Vec3::Zero();
    double radius = 0;
  };

  void build(std::size_t node, int from, int to, const std::vector<OrientedBox>& boxes);

  template <class Test>
  bool any_below(std::size_t node, int from, int to, const OrientedBox& box, double slack, int last,
                 const Test& is_met) const {
    if (from > last || distance(box, spheres_[node].center) >= slack + spheres_[node].radius) return false;
    if (to - from == 1) return is_met(from);
    const int middle = (from + to) / 2;
    return any_below(2 * node + 1, from, middle, box, slack, last, is_met) ||
           any_below(2 * node + 2, middle, to, box, slack, last, is_met);
  }

  int size_;
  std::vector<Sphere> spheres_;  // of a node's children at 2 node + 1 and + 2
};

class PeelBodies {
 public:
  // As peel() has them.
  PeelBodies(const Linkage& chain, int sign, double air);

  int num_panels() const { return static_cast<int>(standing_.size()); }
  const Hinge& hinge(int h) const { return chain_.hinges[h]; }
  const OrientedBox& standing(int panel) const { return standing_[panel]; }
  const RunTree& standing_tree() const { return tree_; }
  const Pose& pose(int panel) const { return pose_[panel]; }
  // Bodies nearer than that count as touching: what only just passes could not be proven by another's arithmetic.
  double least_gap() const { return air_ / 10; }
  double pile_angle(int h) const { return (h % 2 ? -sign_ : sign_) * kPi; }

  OrientedBox panel(int p) const;  // flat, as the linkage has it
  // The panels from `first` to `last`, piled upon panel `on`; flat as that one.
  OrientedBox pile(int first, int last, int on) const;
  // All that are piled upon `on`, in pieces twice as long each: what is near the hinge moves little, and is near much.
  std::vector<OrientedBox> tower(int on) const;

 private:
  const Linkage& chain_;
  double sign_, half_side_, half_thickness_, air_;
  std::vector<Pose> pose_;
  std::vector<OrientedBox> standing_;
  RunTree tree_;
};

}  // namespace plico
