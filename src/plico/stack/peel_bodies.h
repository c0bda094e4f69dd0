// The chain of a peel as boxes: where every panel stands in the shape, and the tower of all that follow one.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/geom/box_tree.h"
#include "plico/geom/oriented_box.h"

namespace plico {

// Boxes in the order of the chain, in trees of so many: what comes after a panel is not looked at, and what follows
// each other is near.
class StandingTrees {
 public:
  explicit StandingTrees(const std::vector<OrientedBox>& boxes);

  static constexpr int kBlock = 128;

  // Does `is_met` say yes to one of the boxes 0 .. last? Asked are those that may come nearer than `slack` to `box`.
  template <class Test>
  bool any_near(const OrientedBox& box, double slack, int last, const Test& is_met) const {
    const Vec3 half = box.axes.cwiseAbs() * box.half + Vec3::Constant(slack);
    const Vec3 low = box.center - half, high = box.center + half;
    const auto enters = [&](const Eigen::AlignedBox3d& other) {
      return (low.array() <= other.max().array()).all() && (other.min().array() <= high.array()).all() &&
             distance(box, other.center()) < slack + other.diagonal().norm() / 2;
    };
    for (int first = 0, block = 0; first <= last && block < static_cast<int>(trees_.size()); first += kBlock, ++block)
      if (trees_[block].any(enters, [&](int i) { return first + i <= last && is_met(first + i); })) return true;
    return false;
  }

 private:
  std::vector<BoxTree> trees_;
};

class PeelBodies {
 public:
  // As peel() has them.
  PeelBodies(const Linkage& chain, int sign, double air);

  int num_panels() const { return static_cast<int>(standing_.size()); }
  const Hinge& hinge(int h) const { return chain_.hinges[h]; }
  const OrientedBox& standing(int panel) const { return standing_[panel]; }
  const StandingTrees& standing_trees() const { return trees_; }
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
  StandingTrees trees_;
};

}  // namespace plico
