#include "plico/unfold/dual_tree.h"

#include <algorithm>
#include <array>

#include "plico/base/error.h"
#include "plico/unfold/overlap.h"

namespace plico {
namespace {
// Panels with at most this many corners are moved on the stack.
constexpr int kSmall = 16;
// Subtrees from this size on are sampled before they are looked at in full, at this many panels. A sample of fewer
// panels or overlaps than the last two says nothing.
constexpr int kSampledFrom = 192, kSample = 32, kSampleAtLeast = 8, kOverlapsAtLeast = 4;
}  // namespace

DualTree::DualTree(const FlatFaces& faces, const FoldForest& forest)
    : faces_(&faces),
      box_(faces.mesh().num_faces()),
      parent_side_(faces.mesh().num_faces(), -1),
      depth_(faces.mesh().num_faces(), 0),
      size_(faces.mesh().num_faces(), 1),
      grid_(faces.mesh().num_faces(), faces.cell_size()),
      partners_(faces.mesh().num_faces()),
      place_in_overlapping_(faces.mesh().num_faces(), -1),
      heavy_(faces.mesh().num_faces()),
      mark_(faces.mesh().num_faces(), 0) {
  lay(forest);
  find_all_overlaps();
  balance();
}

void DualTree::lay(const FoldForest& forest) {
  at_ = lay_panels(*faces_, forest);
  std::vector<int> order{0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (HalfedgeId h : mesh().halfedges(FaceId(order[i]))) {
      const HalfedgeId g = mesh().twin(h);
      if (!forest.is_fold[mesh().edge(h)] || h == parent_side_[order[i]]) continue;
      const int child = mesh().face(g);
      parent_side_[child] = g;
      depth_[child] = depth_[order[i]] + 1;
      order.push_back(child);
    }
  }
  for (auto f = order.rbegin(); f != order.rend(); ++f)
    if (parent_side_[*f] >= 0) size_[parent(*f)] += size_[*f];
}

void DualTree::find_all_overlaps() {
  for (int f = 0; f < mesh().num_faces(); ++f) {
    box_[f] = box_of(corners(f), faces_->degree(f));
    grid_.visit_meeting(box_[f], [&](int other) {
      if (faces_->overlap(f, corners(f), other, corners(other))) add_pair(f, other);
      return true;
    });
    grid_.insert(f, box_[f]);
  }
}

void DualTree::add_pair(int a, int b) {
  ++num_overlaps_;
  for (const auto& [panel, partner] : {std::pair(a, b), std::pair(b, a)}) {
    if (partners_[panel].empty()) {
      place_in_overlapping_[panel] = static_cast<int>(overlapping_.size());
      overlapping_.push_back(panel);
    }
    partners_[panel].push_back(partner);
  }
}

int DualTree::weight(int a, int b) const {
  const auto [low, high] = std::minmax(a, b);
  for (const auto& [panel, weight] : heavy_[low])
    if (panel == high) return weight;
  return 1;
}

void DualTree::aggravate(int a, int b, int by) {
  const auto [low, high] = std::minmax(a, b);
  for (auto& [panel, weight] : heavy_[low])
    if (panel == high) {
      weight += by;
      return;
    }
  heavy_[low].emplace_back(high, 1 + by);
}

void DualTree::drop_partner(int panel, int partner) {
  std::vector<int>& list = partners_[panel];
  *std::find(list.begin(), list.end(), partner) = list.back();
  list.pop_back();
  if (!list.empty()) return;
  const int place = place_in_overlapping_[panel], last = overlapping_.back();
  overlapping_[place] = last;
  place_in_overlapping_[last] = place;
  overlapping_.pop_back();
  place_in_overlapping_[panel] = -1;
}

FoldForest DualTree::forest() const {
  FoldForest forest{std::vector<char>(mesh().num_edges(), 0)};
  for (int side : parent_side_)
    if (side >= 0) forest.is_fold[mesh().edge(HalfedgeId(side))] = 1;
  return forest;
}

std::span<const int> DualTree::gather(int panel) {
  ++stamp_;
  subtree_.clear();
  subtree_.push_back(panel);
  mark_[panel] = stamp_;
  for (std::size_t i = 0; i < subtree_.size(); ++i) {
    for (HalfedgeId h : mesh().halfedges(FaceId(subtree_[i]))) {
      const HalfedgeId g = mesh().twin(h);
      if (!g.valid()) continue;
      const int child = mesh().face(g);
      if (parent_side_[child] != g || mark_[child] == stamp_) continue;
      mark_[child] = stamp_;
      subtree_.push_back(child);
    }
  }
  return subtree_;
}

int DualTree::overlaps_with_rest() const {
  int count = 0;
  for (int panel : subtree_)
    for (int partner : partners_[panel]) count += gathered(partner) ? 0 : weight(panel, partner);
  return count;
}

Motion2 DualTree::motion_for(int side) const {
  const HalfedgeId h(side), g = mesh().twin(h);
  return carry(at_[h], at_[mesh().next(h)], at_[mesh().next(g)], at_[g]);
}

int DualTree::overlaps_if_moved(int panel, const Motion2& motion, int limit) const {
  std::array<Vec2, kSmall> small;
  std::vector<Vec2> large;
  const int n = faces_->degree(panel);
  Vec2* moved = small.data();
  if (n > kSmall) {
    large.resize(n);
    moved = large.data();
  }
  const Vec2* from = corners(panel);
  for (int i = 0; i < n; ++i) moved[i] = motion(from[i]);
  int count = 0;
  grid_.visit_meeting(box_of(moved, n), [&](int other) {
    if (!gathered(other) && faces_->overlap(panel, moved, other, corners(other))) count += weight(panel, other);
    return count < limit;
  });
  return count;
}

int DualTree::overlaps_if_hung(int side, int limit, long& looked) const {
  const Motion2 motion = motion_for(side);
  int count = 0;
  for (int panel : subtree_) {
    ++looked;
    count += overlaps_if_moved(panel, motion, limit - count);
    if (count >= limit) break;
  }
  return count;
}

bool DualTree::sample_overlaps_often(const Motion2& motion, int limit, long& looked) const {
  const std::size_t stride = subtree_.size() / kSample;
  long count = 0, panels = 0;
  for (std::size_t i = stride / 2; i < subtree_.size(); i += stride) {
    ++looked;
    ++panels;
    count += overlaps_if_moved(subtree_[i], motion, limit);
    if (count >= limit) return true;
    const bool enough = panels >= kSampleAtLeast && count >= kOverlapsAtLeast;
    if (enough && count * static_cast<long>(subtree_.size()) > 2L * kSample * limit) return true;
  }
  return false;
}

int DualTree::overlaps_if_hung_sampled(int side, int limit, long& looked) {
  const Motion2 motion = motion_for(side);
  if (subtree_.size() >= kSampledFrom && sample_overlaps_often(motion, limit, looked)) return limit;
  // Most hangings fail beside the new fold, or where the one before failed.
  const int beside = mesh().face(HalfedgeId(side));
  const int failed = failed_at_ >= 0 && failed_at_ != beside && gathered(failed_at_) ? failed_at_ : -1;
  int count = 0;
  const auto reaches_limit = [&](int panel) {
    ++looked;
    count += overlaps_if_moved(panel, motion, limit - count);
    if (count < limit) return false;
    failed_at_ = panel;
    return true;
  };
  if (reaches_limit(beside) || (failed >= 0 && reaches_limit(failed))) return count;
  for (int panel : subtree_)
    if (panel != beside && panel != failed && reaches_limit(panel)) break;
  return count;
}

void DualTree::forget_pairs_of_gathered() {
  for (int panel : subtree_) {
    grid_.remove(panel, box_[panel]);
    for (std::size_t i = 0; i < partners_[panel].size();) {
      const int partner = partners_[panel][i];
      if (gathered(partner)) {
        ++i;
        continue;
      }
      --num_overlaps_;
      drop_partner(partner, panel);
      drop_partner(panel, partner);
    }
  }
}

void DualTree::find_pairs_of_gathered() {
  for (int panel : subtree_) {
    box_[panel] = box_of(corners(panel), faces_->degree(panel));
    grid_.visit_meeting(box_[panel], [&](int other) {  // the grid holds only the rest
      if (faces_->overlap(panel, corners(panel), other, corners(other))) add_pair(panel, other);
      return true;
    });
  }
  for (int panel : subtree_) grid_.insert(panel, box_[panel]);
}

void DualTree::turn_round(int panel) {
  int side = -1;
  for (int p = panel; p >= 0;) {
    const int up = parent_side_[p], next = up < 0 ? -1 : face_across(up);
    parent_side_[p] = side;
    side = up < 0 ? -1 : static_cast<int>(mesh().twin(HalfedgeId(up)));
    p = next;
  }
}

void DualTree::measure_gathered() {
  for (int panel : subtree_) {
    size_[panel] = 1;
    depth_[panel] = parent_side_[panel] < 0 ? 0 : depth_[parent(panel)] + 1;
  }
  for (std::size_t i = subtree_.size() - 1; i > 0; --i) size_[parent(subtree_[i])] += size_[subtree_[i]];
}

void DualTree::hang(int side) {
  const Motion2 motion = motion_for(side);
  const int top = subtree_[0], new_top = mesh().face(HalfedgeId(side)), count = static_cast<int>(subtree_.size());
  forget_pairs_of_gathered();
  for (int panel : subtree_) {
    Vec2* at = &at_[mesh().soup().offsets[panel]];
    for (int i = 0; i < faces_->degree(panel); ++i) at[i] = motion(at[i]);
  }
  find_pairs_of_gathered();
  for (int p = parent(top); p >= 0; p = parent(p)) size_[p] -= count;
  parent_side_[top] = -1;
  turn_round(new_top);
  parent_side_[new_top] = side;
  for (int p = parent(new_top); p >= 0; p = parent(p)) size_[p] += count;
  gather(new_top);
  measure_gathered();
}

void DualTree::balance() {
  const int n = mesh().num_faces();
  int centroid = root_;
  for (bool moved = true; moved;) {
    moved = false;
    for (HalfedgeId h : mesh().halfedges(FaceId(centroid))) {
      const HalfedgeId g = mesh().twin(h);
      if (!g.valid() || parent_side_[mesh().face(g)] != g || 2 * size_[mesh().face(g)] <= n) continue;
      centroid = mesh().face(g);
      moved = true;
      break;
    }
  }
  if (centroid == root_) return;
  turn_round(centroid);
  root_ = centroid;
  gather(root_);
  measure_gathered();
}

}  // namespace plico
