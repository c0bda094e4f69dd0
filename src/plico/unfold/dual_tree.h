// A spanning tree of a mesh's dual graph laid flat, with the overlaps of its panels kept up to date while subtrees are
// cut off and hung elsewhere: the working state of a search for a net.
#pragma once
#include <span>
#include <vector>

#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"
#include "plico/unfold/panel_grid.h"

namespace plico {

class DualTree {
 public:
  // The mesh of `faces` must be connected and `forest` one spanning tree of it. O(n + overlaps).
  DualTree(const FlatFaces& faces, const FoldForest& forest);

  int num_overlaps() const { return num_overlaps_; }
  // Panels that overlap some other, and for each panel those that it overlaps; no particular but repeatable order.
  std::span<const int> overlapping_panels() const { return overlapping_; }
  std::span<const int> overlapping(int panel) const { return partners_[panel]; }

  int root() const { return root_; }
  int parent(int panel) const { return parent_side_[panel] < 0 ? -1 : face_across(parent_side_[panel]); }
  int parent_side(int panel) const { return parent_side_[panel]; }  // halfedge of `panel` across which it hangs, or -1
  int depth(int panel) const { return depth_[panel]; }
  int subtree_size(int panel) const { return size_[panel]; }
  const Vec2* corners(int panel) const { return &at_[mesh().soup().offsets[panel]]; }  // as laid
  const Mesh& mesh() const { return faces_->mesh(); }
  FoldForest forest() const;

  // The panels of the subtree under `panel`, that one first, each after its parent. Valid until the next call.
  std::span<const int> gather(int panel);
  std::span<const int> branch() const { return subtree_; }           // the same, again
  bool gathered(int panel) const { return mark_[panel] == stamp_; }  // by the last gather()

  // Makes the overlap of two panels count `by` more in the two functions below (breakout, Morris 1993); 1 at first.
  void aggravate(int a, int b, int by);

  // Weighted overlaps between the gathered subtree and the rest: as it lies, and as it would lie hung by its halfedge
  // `side` to the panel across, which is not gathered. Stops counting at `limit`. Adds the panels looked at to
  // `looked`.
  int overlaps_with_rest() const;
  int overlaps_if_hung(int side, int limit, long& looked) const;
  // The same, for large meshes: looks first where hangings are known to fail. Gives `limit` without looking further
  // when panels spread over a big subtree say that more than twice as many would overlap.
  int overlaps_if_hung_sampled(int side, int limit, long& looked);

  // How the gathered subtree would move if it were hung by `side`.
  Motion2 motion_for(int side) const;

  // Cuts the gathered subtree off and hangs it by `side`. O(subtree + depth).
  void hang(int side);

  // Moves the root to the tree's centroid, so that no subtree has more than half of the panels.
  void balance();

 private:
  int face_across(int halfedge) const { return mesh().face(mesh().twin(HalfedgeId(halfedge))); }
  void lay(const FoldForest& forest);
  void find_all_overlaps();
  void add_pair(int a, int b);
  void forget_pairs_of_gathered();
  void find_pairs_of_gathered();
  int weight(int a, int b) const;
  int overlaps_if_moved(int panel, const Motion2& motion, int limit) const;
  bool sample_overlaps_often(const Motion2& motion, int limit, long& looked) const;
  void drop_partner(int panel, int partner);
  void turn_round(int panel);  // makes `panel` the root of its subtree's tree
  void measure_gathered();     // depths and sizes below the first gathered panel

  const FlatFaces* faces_;
  std::vector<Vec2> at_;  // one per halfedge
  std::vector<Box2> box_;
  std::vector<int> parent_side_, depth_, size_;
  int root_ = 0;
  PanelGrid grid_;

  std::vector<std::vector<int>> partners_;
  std::vector<int> overlapping_, place_in_overlapping_;
  std::vector<std::vector<std::pair<int, int>>> heavy_;  // by lower panel: higher panel, weight above 1
  int num_overlaps_ = 0;

  std::vector<int> subtree_, mark_;
  int stamp_ = 0;
  int failed_at_ = -1;  // the panel at which overlaps_if_hung_sampled last reached its limit
};

}  // namespace plico
