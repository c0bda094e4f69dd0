#include "plico/segment/ridges.h"

#include <algorithm>
#include <numeric>

namespace plico {
namespace {

// Vertices are added one by one; a component remembers whether it reaches the hull.
class MergeTree {
 public:
  explicit MergeTree(int n) : up_(n, -1), on_hull_(n, 0), size_(n, 0) {}

  bool has(int v) const { return up_[v] >= 0; }
  void add(int v, bool on_hull) { up_[v] = v, on_hull_[v] = on_hull, size_[v] = 1; }
  int root(int v) {
    while (up_[v] != v) v = up_[v] = up_[up_[v]];
    return v;
  }
  bool is_ridge(int root) const { return on_hull_[root] != 0; }
  int size(int root) const { return size_[root]; }
  void join(int a, int b) {
    a = root(a), b = root(b);
    if (a == b) return;
    up_[b] = a;
    on_hull_[a] |= on_hull_[b];
    size_[a] += size_[b];
  }

 private:
  std::vector<int> up_;
  std::vector<char> on_hull_;
  std::vector<int> size_;
};

std::vector<std::vector<int>> neighbours(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch) {
  std::vector<std::vector<int>> around(patch.vertex.size());
  for (int f : faces)
    for (HalfedgeId h : mesh.halfedges(FaceId(f))) {
      const int a = patch.at(mesh.from(h)), b = patch.at(mesh.to(h));
      around[a].push_back(b);
      around[b].push_back(a);
    }
  return around;
}

std::vector<int> by_depth(const PatchVertices& patch) {
  std::vector<int> order(patch.vertex.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return patch.depth[a] < patch.depth[b]; });
  return order;
}

// The roots of the ridges around a vertex, the largest first.
std::vector<int> ridges_around(MergeTree& tree, const std::vector<int>& around) {
  std::vector<int> roots;
  for (int w : around)
    if (tree.has(w) && tree.is_ridge(tree.root(w))) roots.push_back(tree.root(w));
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) { return tree.size(a) > tree.size(b); });
  return roots;
}

// Adds the vertices up to number `until` of the order; returns the number of the last vertex at which ridges joined.
int grow(MergeTree& tree, const std::vector<int>& order, int until, const PatchVertices& patch,
         const std::vector<std::vector<int>>& around, double on_hull) {
  int last = -1;
  for (int i = 0; i < until; ++i) {
    const int v = order[i];
    if (ridges_around(tree, around[v]).size() > 1) last = i;
    tree.add(v, patch.depth[v] <= on_hull);
    for (int w : around[v])
      if (tree.has(w)) tree.join(v, w);
  }
  return last;
}

}  // namespace

std::optional<RidgePair> deepest_ridges(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                                        double least) {
  const auto around = neighbours(mesh, faces, patch);
  const std::vector<int> order = by_depth(patch);
  const int n = static_cast<int>(order.size());
  const double on_hull = 1e-9 * patch.deepest();  // rounding of depths
  MergeTree whole(n);
  const int saddle = grow(whole, order, n, patch, around, on_hull);
  if (saddle < 0 || patch.depth[order[saddle]] <= least) return std::nullopt;
  // Again up to the saddle, where both ridges are still apart.
  MergeTree tree(n);
  grow(tree, order, saddle, patch, around, on_hull);
  const std::vector<int> ridges = ridges_around(tree, around[order[saddle]]);
  RidgePair pair{patch.depth[order[saddle]], std::vector<char>(n, 0)};
  for (int v = 0; v < n; ++v)
    if (tree.has(v)) pair.side_of_vertex[v] = tree.root(v) == ridges[0] ? 1 : tree.root(v) == ridges[1] ? 2 : 0;
  return pair;
}

}  // namespace plico
