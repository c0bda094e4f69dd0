// A file that folds, to be looked at on its way: a net, a crease pattern or a stack with or without a motion. Knows
// nothing of JavaScript.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/folding_path.h"

namespace plico {

class MotionPlayer {
 public:
  // FOLD bytes. Without a motion every fold angle turns evenly; a stack without one stays as it is. Throws InvalidInput
  // as read_fold() and make_linkage() do.
  MotionPlayer(const std::string& bytes, const std::string& name);

  // Corners panel by panel: panel p has offsets[p] .. offsets[p + 1].
  const std::vector<int>& offsets() const { return offsets_; }
  // Of every corner the side from it to the next, numbered 0..num_edges()-1; panels share what they are hinged at.
  const std::vector<int>& corner_edges() const { return corner_edges_; }
  int num_edges() const { return num_edges_; }
  std::vector<float> flat_corners() const;  // 2 numbers a corner
  // At a time in [0, 1]: 3 numbers a corner.
  std::vector<float> corners_at(double time) const;

 private:
  Linkage linkage_;
  FoldingPath path_;
  std::vector<int> offsets_{0}, corner_edges_;
  int num_edges_ = 0;
};

}  // namespace plico
