// The convex hull of a tree's panels while branches are hung elsewhere.
#pragma once
#include <vector>

#include "plico/unfold/dual_tree.h"

namespace plico {

class HullTracker {
 public:
  explicit HullTracker(const DualTree& tree);

  const std::vector<Vec2>& hull() const { return hull_; }     // counter-clockwise
  const std::vector<int>& panels() const { return panels_; }  // those with a corner on the hull

  // A part of the hull if the gathered branch were hung by `side`: what is left of the present one and the branch
  // moved. All of it, exactly when the branch does not touch the hull now. O(branch log branch).
  const std::vector<Vec2>& least_hull_if_hung(int side);

  // The whole hull, for the side for which least_hull_if_hung() was asked last. O(n) when the branch touches the hull.
  const std::vector<Vec2>& hull_if_hung(int side);

  // To be called after each hang() of a branch for which hull_if_hung() was asked last, and after nothing else.
  void accept();

 private:
  std::vector<Vec2> hull_without_branch();  // and whether that touches it
  static std::vector<Vec2> outer_points(const std::vector<Vec2>& points);
  void find_panels();

  const DualTree& tree_;
  std::vector<Vec2> hull_, proposed_;
  std::vector<int> panels_;
  std::vector<char> on_hull_;  // by panel
  bool touches_ = false;
};

}  // namespace plico
