#include "plico/stack/cyclic_sequences.h"

#include <utility>

namespace plico {

CyclicSequences::CyclicSequences(int n, Rng rng) : nodes_(n) {
  for (Node& node : nodes_) node.priority = static_cast<std::uint32_t>(rng.next());
}

int CyclicSequences::root(int v) const {
  while (nodes_[v].parent >= 0) v = nodes_[v].parent;
  return v;
}

// Reversals that wait at `v` and above swap left and right; those above a node decide on which side of it `v` lies.
int CyclicSequences::position(int v) const {
  int before = size_of(nodes_[v].left), after = size_of(nodes_[v].right);
  if (nodes_[v].reversed) std::swap(before, after);
  for (int child = v, node = nodes_[v].parent; node >= 0; child = node, node = nodes_[node].parent) {
    const Node& n = nodes_[node];
    if (n.left == child)
      after += size_of(n.right) + 1;
    else
      before += size_of(n.left) + 1;
    if (n.reversed) std::swap(before, after);
  }
  return before;
}

int CyclicSequences::at(int root, int position) {
  while (true) {
    hand_on_reversal(root);
    const int left = size_of(nodes_[root].left);
    if (position == left) return root;
    if (position < left) {
      root = nodes_[root].left;
    } else {
      position -= left + 1;
      root = nodes_[root].right;
    }
  }
}

int CyclicSequences::join(int first, int second) {
  if (first < 0) return second;
  if (second < 0) return first;
  if (nodes_[first].priority >= nodes_[second].priority) {
    hand_on_reversal(first);
    nodes_[first].right = join(nodes_[first].right, second);
    renew(first);
    return first;
  }
  hand_on_reversal(second);
  nodes_[second].left = join(first, nodes_[second].left);
  renew(second);
  return second;
}

std::pair<int, int> CyclicSequences::cut(int root, int position) {
  if (root < 0) return {-1, -1};
  hand_on_reversal(root);
  const int left = nodes_[root].left, right = nodes_[root].right;
  for (int child : {left, right})
    if (child >= 0) nodes_[child].parent = -1;
  std::pair<int, int> halves;
  if (position <= size_of(left)) {
    halves = cut(left, position);
    nodes_[root].left = halves.second;
    halves.second = root;
  } else {
    halves = cut(right, position - size_of(left) - 1);
    nodes_[root].right = halves.first;
    halves.first = root;
  }
  renew(root);
  nodes_[root].parent = -1;
  return halves;
}

void CyclicSequences::reverse(int root) { nodes_[root].reversed = !nodes_[root].reversed; }

std::vector<int> CyclicSequences::sequence(int root) {
  std::vector<int> numbers, open;
  for (int node = root; node >= 0 || !open.empty();) {
    for (; node >= 0; node = nodes_[node].left) {
      hand_on_reversal(node);
      open.push_back(node);
    }
    node = open.back();
    open.pop_back();
    numbers.push_back(node);
    node = nodes_[node].right;
  }
  return numbers;
}

void CyclicSequences::hand_on_reversal(int node) {
  Node& n = nodes_[node];
  if (!n.reversed) return;
  std::swap(n.left, n.right);
  for (int child : {n.left, n.right})
    if (child >= 0) nodes_[child].reversed = !nodes_[child].reversed;
  n.reversed = false;
}

void CyclicSequences::renew(int node) {
  Node& n = nodes_[node];
  n.size = 1 + size_of(n.left) + size_of(n.right);
  for (int child : {n.left, n.right})
    if (child >= 0) nodes_[child].parent = node;
}

}  // namespace plico
