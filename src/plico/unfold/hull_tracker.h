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

  // The hull if the gathered branch were hung by `side`. O(branch) when it neither touches the hull nor leaves it,
  // otherwise O(n).
  const std::vector<Vec2>& hull_if_hung(int side);

  // To be called after each hang() of a branch for which hull_if_hung() was asked last, and after nothing else.
  void accept();

 private:
  bool keeps_hull(const Motion2& motion) const;
  bool contains(const Vec2& p) const;
  void collect(const Motion2& motion);
  std::vector<Vec2> outer_points() const;
  void find_panels();

  const DualTree& tree_;
  std::vector<Vec2> hull_, proposed_, points_;
  std::vector<int> panels_;
  std::vector<char> on_hull_;  // by panel
  bool changed_ = false;
};

}  // namespace plico
