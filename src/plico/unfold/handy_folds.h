// What hands can do with a net: folds that are too short for what hangs on them, and needles that hang by their short
// side, kept at hand while branches of a tree are hung elsewhere.
#pragma once
#include <vector>

#include "plico/unfold/dual_tree.h"

namespace plico {

// A fold carries the smaller of the two pieces that it joins. Up to so many panels even a short one carries.
inline constexpr int kLightBranch = 3;
// A needle's longest side is more than so many times its shortest.
inline constexpr double kNeedle = 3;

struct HandFaults {
  double weak_folds = 0;  // folds under `shortest` that carry more than kLightBranch panels: 1 each, and what is
                          // missing of the length as a share of `shortest`
  double needles = 0;     // panels whose folds are all shorter than half of a longer side that could be a fold
};

class HandyFolds {
 public:
  // `shortest` in units, at least 0.
  HandyFolds(const DualTree& tree, double shortest);

  HandFaults all() const;  // O(n)
  // How much they change if the gathered branch were hung by `side`. O(depth).
  HandFaults change_if_hung(int side) const;

 private:
  double weakness(int fold, int carried) const;
  bool is_fold(int halfedge) const;
  bool hangs_badly(int panel, int fold_gone, int fold_new) const;

  const DualTree& tree_;
  const Mesh& mesh_;
  double shortest_;
  std::vector<double> length_;       // by halfedge
  std::vector<char> is_needle_;      // by panel
  std::vector<double> long_enough_;  // by panel: half of its longest side that has a neighbour
};

}  // namespace plico
