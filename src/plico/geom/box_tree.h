// Which boxes of a set overlap: a balanced tree of bounding boxes.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

class BoxTree {
 public:
  // O(n log n).
  explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);

  // Calls visit(i, j), i < j, once for every pair whose closed boxes meet, until it returns false. The order is the
  // same in every run. O(n log n + pairs) for boxes of similar size.
  void overlapping_pairs(const std::function<bool(int, int)>& visit) const;

  // Does test(i) say yes to some box? enters(Eigen::AlignedBox3d) is asked first, of each box and of those around it;
  // what it says no to is left out with all that lies inside.
  template <class Enters, class Test>
  bool any(const Enters& enters, const Test& test) const {
    return !nodes_.empty() && any_below(0, enters, test);
  }

  // The least distance(i), which must be at least that of `p` to box i; infinite for an empty tree. O(log n) when boxes
  // are small.
  double nearest(const Vec3& p, const std::function<double(int)>& distance) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, last = 0;  // of order_
    int left = -1, right = -1;
  };
  int build(int first, int last);

  template <class Enters, class Test>
  bool any_below(int index, const Enters& enters, const Test& test) const {
    const Node& node = nodes_[index];
    if (!enters(node.box)) return false;
    if (node.left >= 0) return any_below(node.left, enters, test) || any_below(node.right, enters, test);
    for (int i = node.first; i < node.last; ++i)
      if (enters(leaf_boxes_[i]) && test(order_[i])) return true;
    return false;
  }

  std::span<const Eigen::AlignedBox3d> boxes_;  // only while building; copied into the leaves
  std::vector<Eigen::AlignedBox3d> leaf_boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace plico
