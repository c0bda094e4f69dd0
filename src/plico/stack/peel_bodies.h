// The chain of a peel as boxes: where every panel stands in the shape, and the tower of all that follow one.
#pragma once
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/geom/oriented_box.h"

namespace plico {

// What is near among boxes along the axes: boxes around boxes, halved across their longest side down to single ones.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<OrientedBox>& boxes);

  // Does `is_met` say yes to one of the boxes 0 .. last? Asked are those that may come nearer than `slack` to `box`.
  template <class Test>
  bool any_near(const OrientedBox& box, double slack, int last, const Test& is_met) const {
    const Vec3 half = box.axes.cwiseAbs() * box.half + Vec3::Constant(slack);
    return any_below(0, {box, slack, last, box.center - half, box.center + half}, is_met);
  }

 private:
  struct Node {
    Vec3 low, high;
    double radius = 0;
    int first = 0;          // of the boxes in it the one with the lowest number
    std::size_t right = 0;  // its second half, the first one is next; 0: a single box
  };
  struct Query {
    const OrientedBox& box;
    double slack;
    int last;
    Vec3 low, high;
  };

  void build(std::vector<int>::iterator begin, std::vector<int>::iterator end, const std::vector<OrientedBox>& boxes);

  static bool may_touch(const Node& node, const Query& query) {
    return node.first <= query.last && (query.low.array() <= node.high.array()).all() &&
           (node.low.array() <= query.high.array()).all() &&
           distance(query.box, (node.low + node.high) / 2) < query.slack + node.radius;
  }

  template <class Test>
  bool any_below(std::size_t at, const Query& query, const Test& is_met) const {
    const Node& node = nodes_[at];
    if (!may_touch(node, query)) return false;
    if (node.right == 0) return is_met(node.first);
    return any_below(at + 1, query, is_met) || any_below(node.right, query, is_met);
  }

  std::vector<Node> nodes_;
};

class PeelBodies {
 public:
  // As peel() has them.
  PeelBodies(const Linkage& chain, int sign, double air);

  int num_panels() const { return static_cast<int>(standing_.size()); }
  const Hinge& hinge(int h) const { return chain_.hinges[h]; }
  const OrientedBox& standing(int panel) const { return standing_[panel]; }
  const BoxTree& standing_tree() const { return tree_; }
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
  BoxTree tree_;
};

}  // namespace plico
