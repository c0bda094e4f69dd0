#include "plico/geom/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace plico {
namespace {
constexpr int kLeafSize = 4;

// Eigen's own intersects() builds temporaries; this is the inner loop of every query.
bool meet(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.min()[axis] > b.max()[axis] || b.min()[axis] > a.max()[axis]) return false;
  return true;
}
}  // namespace

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes) : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes.empty()) build(0, static_cast<int>(boxes.size()));
  for (int i : order_) leaf_boxes_.push_back(boxes[i]);
  boxes_ = {};
}

int BoxTree::build(int first, int last) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.first = first;
  node.last = last;
  for (int i = first; i < last; ++i) node.box.extend(boxes_[order_[i]]);
  if (last - first > kLeafSize) {
    Eigen::Index axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const int middle = first + (last - first) / 2;
    const auto key = [&](int i) { return boxes_[i].min()[axis] + boxes_[i].max()[axis]; };
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    node.left = build(first, middle);
    node.right = build(middle, last);
  }
  nodes_[index] = node;
  return index;
}

void BoxTree::overlapping_pairs(const std::function<bool(int, int)>& visit) const {
  if (nodes_.empty()) return;
  std::vector<std::pair<int, int>> stack = {{0, 0}};
  while (!stack.empty()) {
    const auto [a, b] = stack.back();
    stack.pop_back();
    const Node &m = nodes_[a], &n = nodes_[b];
    if (!meet(m.box, n.box)) continue;
    if (m.left < 0 && n.left < 0) {
      for (int i = m.first; i < m.last; ++i)
        for (int j = a == b ? i + 1 : n.first; j < n.last; ++j)
          if (meet(leaf_boxes_[i], leaf_boxes_[j]) &&
              !visit(std::min(order_[i], order_[j]), std::max(order_[i], order_[j])))
            return;
    } else if (a == b) {
      stack.insert(stack.end(), {{m.left, m.left}, {m.right, m.right}, {m.left, m.right}});
    } else if (n.left < 0 || (m.left >= 0 && m.last - m.first >= n.last - n.first)) {
      stack.insert(stack.end(), {{m.left, b}, {m.right, b}});
    } else {
      stack.insert(stack.end(), {{a, n.left}, {a, n.right}});
    }
  }
}

double BoxTree::nearest(const Vec3& p, const std::function<double(int)>& distance) const {
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, int>> stack;
  const auto push = [&](int node) { stack.emplace_back(nodes_[node].box.exteriorDistance(p), node); };
  if (!nodes_.empty()) push(0);
  while (!stack.empty()) {
    const auto [at_least, index] = stack.back();
    stack.pop_back();
    if (at_least >= least) continue;
    const Node& node = nodes_[index];
    if (node.left < 0) {
      for (int i = node.first; i < node.last; ++i)
        if (leaf_boxes_[i].exteriorDistance(p) < least) least = std::min(least, distance(order_[i]));
      continue;
    }
    push(node.left);
    push(node.right);
    if (stack[stack.size() - 2].first < stack.back().first) std::swap(stack[stack.size() - 2], stack.back());
  }
  return least;
}

}  // namespace plico
