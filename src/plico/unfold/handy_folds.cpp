#include "plico/unfold/handy_folds.h"

#include <algorithm>

#include "plico/mesh/measures.h"

namespace plico {

HandyFolds::HandyFolds(const DualTree& tree, double shortest)
    : tree_(tree), mesh_(tree.mesh()), shortest_(shortest), length_(mesh_.num_halfedges()) {
  for (FaceId f : mesh_.faces()) {
    double least = 0, most = 0, joinable = 0;
    for (HalfedgeId h : mesh_.halfedges(f)) {
      const double side = length_[h] = length(mesh_, mesh_.edge(h));
      least = most == 0 ? side : std::min(least, side);
      most = std::max(most, side);
      if (mesh_.twin(h).valid()) joinable = std::max(joinable, side);
    }
    is_needle_.push_back(most > kNeedle * least);
    long_enough_.push_back(joinable / 2);
  }
}

double HandyFolds::weakness(int fold, int carried) const {
  const double l = length_[fold];
  if (l >= shortest_ || std::min(carried, mesh_.num_faces() - carried) <= kLightBranch) return 0;
  return 1 + (shortest_ - l) / shortest_;
}

bool HandyFolds::is_fold(int halfedge) const {
  const HalfedgeId h(halfedge), g = mesh_.twin(h);
  if (!g.valid()) return false;
  return tree_.parent_side(mesh_.face(h)) == halfedge || tree_.parent_side(mesh_.face(g)) == g;
}

// With one fold less and another one more, each named by either of its halfedges; -1 for none.
bool HandyFolds::hangs_badly(int panel, int fold_gone, int fold_new) const {
  if (!is_needle_[panel]) return false;
  const auto is_one = [&](HalfedgeId h, int fold) { return h == fold || mesh_.twin(h) == fold; };
  for (HalfedgeId h : mesh_.halfedges(FaceId(panel))) {
    const bool folds = is_one(h, fold_new) || (is_fold(h) && !is_one(h, fold_gone));
    if (folds && length_[h] >= long_enough_[panel]) return false;
  }
  return true;
}

HandFaults HandyFolds::all() const {
  HandFaults faults;
  for (int f = 0; f < mesh_.num_faces(); ++f) {
    if (tree_.parent_side(f) >= 0) faults.weak_folds += weakness(tree_.parent_side(f), tree_.subtree_size(f));
    faults.needles += hangs_badly(f, -1, -1);
  }
  return faults;
}

HandFaults HandyFolds::change_if_hung(int side) const {
  const int top = tree_.branch().front(), moved = tree_.subtree_size(top), gone = tree_.parent_side(top);
  const int holder = mesh_.face(HalfedgeId(side)), beside = mesh_.face(mesh_.twin(HalfedgeId(side)));
  HandFaults change;
  const auto recount = [&](int panel, int carried) {
    const int fold = tree_.parent_side(panel);
    change.weak_folds += weakness(fold, carried) - weakness(fold, tree_.subtree_size(panel));
  };
  // The folds between the old place and the new one carry the branch no more, or now.
  for (int from = tree_.parent(top), to = beside; from != to;) {
    const bool leaves = tree_.depth(from) >= tree_.depth(to);
    int& at = leaves ? from : to;
    recount(at, tree_.subtree_size(at) + (leaves ? -moved : moved));
    at = tree_.parent(at);
  }
  // Those between its old top and its new one carry what they did not.
  for (int at = holder; at != top; at = tree_.parent(at)) recount(at, moved - tree_.subtree_size(at));
  change.weak_folds += weakness(side, moved) - weakness(gone, moved);

  int looked_at[4] = {top, tree_.parent(top), holder, beside};
  std::sort(std::begin(looked_at), std::end(looked_at));
  const auto* end = std::unique(std::begin(looked_at), std::end(looked_at));
  for (const int* panel = looked_at; panel != end; ++panel)
    change.needles += hangs_badly(*panel, gone, side) - hangs_badly(*panel, -1, -1);
  return change;
}

}  // namespace plico
