// The convex hulls of a tree's pieces while branches are hung elsewhere: of the whole, or of what is left when some of
// its folds are cut for printing.
#pragma once
#include <vector>

#include "plico/unfold/dual_tree.h"

namespace plico {

using Hull2 = std::vector<Vec2>;  // counter-clockwise

class HullTracker {
 public:
  // `is_cut`: by edge of the mesh, folds that are cut; empty for none.
  explicit HullTracker(const DualTree& tree, const std::vector<char>& is_cut = {});

  const std::vector<Hull2>& hulls() const { return hulls_; }  // of each piece
  const std::vector<int>& panels() const { return panels_; }  // those with a corner on the hull of their piece
  int piece(int panel) const { return piece_[panel]; }

  // What of the gathered branch hangs by its top in one piece goes along to the piece of the panel across; the pieces
  // beyond cuts stay as they are. It may be one and the same piece, and is when there are no cuts.
  struct Change {
    int from = 0, to = 0;  // pieces
    Hull2 left, gained;    // what they would be; the first is the second where from is to
  };

  // A part of the hulls if the gathered branch were hung by `side`, whose panel must be in the piece of the branch's
  // top: what is left of the present one and what moves. All of it, exactly when that does not touch the hull now.
  // O(branch log branch).
  const Change& least_if_hung(int side);

  // The whole hulls, for the side for which least_if_hung() was asked last. O(piece) when the hull is touched.
  const Change& all_if_hung(int side);

  // To be called after each hang() of a branch for which all_if_hung() was asked last, and after nothing else.
  void accept();

 private:
  void find_pieces(const std::vector<char>& is_cut);
  Hull2 hull_without_branch();  // and whether that touches it
  void add_moved(int side, std::vector<Vec2>& points) const;
  bool moves(int panel) const { return tree_.gathered(panel) && piece_[panel] == proposed_.from; }
  static std::vector<Vec2> outer_points(const std::vector<Vec2>& points);
  void find_panels(int piece);

  const DualTree& tree_;
  std::vector<int> piece_;                 // of each panel
  std::vector<std::vector<int>> members_;  // of each piece
  std::vector<Hull2> hulls_;
  Change proposed_;
  std::vector<int> panels_;
  std::vector<char> on_hull_;  // by panel
  bool touches_ = false;
};

}  // namespace plico
