#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

#include "plico/convex/remesh_steps.h"

namespace plico {
namespace {

struct Shrinking {
  double gain = 0;
  int from = 0, to = 0;
  int stamp = 0;  // of both ends together when it was found
  bool keeps_flat = false;
  Vec3 point;

  bool operator<(const Shrinking& other) const {  // the queue gives the greatest first
    return std::tie(other.gain, other.from, other.to) < std::tie(gain, from, to);
  }
};

class EdgeQueue {
 public:
  EdgeQueue(ShellSurface& surface, bool only_fatter, RemeshBudget& budget)
      : surface_(surface),
        only_fatter_(only_fatter),
        budget_(budget),
        stamps_(surface.num_vertices(), 0),
        fat_(fat_sum(surface)) {
    for (const auto& [from, to] : surface.edges()) push(from, to);
  }

  // One edge less; false when none can shrink within the budget.
  bool shrink_one() {
    while (!queue_.empty()) {
      const Shrinking next = queue_.top();
      if (next.gain > budget_.volume) return false;
      queue_.pop();
      if (next.stamp != stamp(next.from, next.to)) continue;
      const auto patch = surface_.patch_of(next.from, next.to, next.keeps_flat);
      // Triangles two edges away may have changed since.
      if (!patch || !surface_.is_allowed(*patch, next.point)) continue;
      const FatSum then = fat_ - fat_sum(surface_, patch->triangles) + fan_sum(surface_, *patch, next.point);
      if (only_fatter_ && then.share() <= fat_.share()) continue;
      fat_ = then;
      surface_.replace(*patch, next.point);
      budget_.volume -= next.gain;
      renew(next.from, next.to);
      return true;
    }
    return false;
  }

 private:
  int stamp(int from, int to) const { return stamps_[from] + stamps_[to]; }

  void push(int from, int to) {
    if (!push(from, to, true)) push(from, to, false);
  }

  bool push(int from, int to, bool keep_flat) {
    const auto patch = surface_.patch_of(from, to, keep_flat);
    if (!patch) return false;
    std::vector<Plane> below = surface_.limits(*patch);
    surface_.add_above(*patch, below);
    const Vec3 middle = (surface_.point(from) + surface_.point(to)) / 2;
    const double reach = 4 * (surface_.point(from) - surface_.point(to)).norm();
    ++budget_.solves;
    const std::vector<Plane> flats = surface_.flats(*patch);
    const auto point = lowest_point({below, flats}, surface_.uphill(*patch), middle, reach);
    if (!point || !surface_.is_allowed(*patch, *point)) return false;
    queue_.push({surface_.gain(*patch, *point), from, to, stamp(from, to), keep_flat, *point});
    return true;
  }

  void renew(int vertex, int gone) {
    ++stamps_[gone];
    ++stamps_[vertex];
    const std::vector<int> around = surface_.neighbours(vertex);
    for (int v : around) ++stamps_[v];
    for (int v : around) {
      push(std::min(v, vertex), std::max(v, vertex));
      for (int w : surface_.neighbours(v))
        if (w != vertex && (v < w || !std::binary_search(around.begin(), around.end(), w)))
          push(std::min(v, w), std::max(v, w));
    }
  }

  ShellSurface& surface_;
  bool only_fatter_;
  RemeshBudget& budget_;
  std::vector<int> stamps_;  // of each vertex: how often triangles around it changed
  FatSum fat_;               // of all triangles
  std::priority_queue<Shrinking> queue_;
};

}  // namespace

bool shrink_edges(ShellSurface& surface, int faces, bool only_fatter, RemeshBudget& budget, const Run& run) {
  if (surface.num_triangles() <= faces) return true;
  EdgeQueue queue(surface, only_fatter, budget);
  while (surface.num_triangles() > faces && !run.over())
    if (!queue.shrink_one()) break;
  return surface.num_triangles() <= faces;
}

}  // namespace plico
