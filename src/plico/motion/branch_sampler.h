// Panels hung together as a tree, frozen at sample times of their common motion from flat to folded, with the
// collisions at every sample kept up to date while branches are cut off and hung elsewhere. A branch moves as one rigid
// piece, so only pairs between it and the rest are looked at. The working state of a search for nets that fold.
#pragma once
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "plico/base/vec.h"
#include "plico/fold/linkage.h"

namespace plico {

// Panels and the pairs of their sides that may be joined.
struct PanelKit {
  std::vector<std::vector<Vec2>> outlines;  // of each panel in its own plane, counter-clockwise seen from the front
  std::vector<int> first_side = {0};        // panels + 1; side first_side[p] + i runs from corner i to corner i + 1
  std::vector<int> twin;                    // of each side, -1 where nothing can be joined
  std::vector<double> fold_angle;           // of each side when folded, radians, valley > 0
  int num_panels() const { return static_cast<int>(outlines.size()); }
};

// The panels as a linkage without hinges, each in its own plane.
Linkage loose_panels(const PanelKit& kit);

// How fold angles follow time: all arrive together, or all turn at one rate and stop.
enum class FoldingLaw { Linear, Uniform };

class BranchSampler {
 public:
  // `clearance` and `touch` as in motion/collision.h.
  BranchSampler(const PanelKit& kit, FoldingLaw law, double clearance, double touch);

  // Joins the panels as told (one joined side of each pair is enough; they must make one tree) and looks at all pairs.
  void reset(const std::vector<char>& is_joined);
  // One more moment, in (0, 1], at which collisions count. O(panels log panels), as reset() for one sample.
  void add_sample(double time);
  // Forgets all but the `most` samples that refuted a hanging lately. There must be no conflict.
  void keep_samples(int most);
  int num_samples() const { return static_cast<int>(samples_.size()); }
  // Corners moved and panels placed since the beginning: goes with the time that was needed, within a tenth or so, but
  // is the same in every run.
  long work() const { return work_; }

  // Pose of the panel over `side`, seen from the panel that has it.
  Pose across(int side, double time) const;

  struct Conflict {
    int sample, panel_a, panel_b;
  };
  const std::vector<Conflict>& conflicts() const { return conflicts_; }

  // Conflicts between `branch` and the rest: now, and if the branch hung by its side `side` (the twin's panel is not in
  // the branch). Stops counting above `limit`.
  long conflicts_across(std::span<const int> branch);
  long conflicts_if_hung(std::span<const int> branch, int side, long limit);
  // Cuts the branch (a connected piece, as is the rest) off and hangs it by `side`.
  void hang(std::span<const int> branch, int side);

 private:
  using Boxes = std::array<std::vector<float>, 6>;  // low x y z, high x y z, rounded outward
  // A pose that is multiplied and applied without the fourth row, in a third of the time.
  struct Rigid {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();
    Rigid operator*(const Rigid& b) const { return {turn * b.turn, turn * b.shift + shift}; }
    Vec3 operator*(const Vec3& p) const { return turn * p + shift; }
    Rigid inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
  };
  struct Sample {
    double time;
    std::vector<Rigid> pose;    // of each panel
    std::vector<Vec3> corners;  // of all plates
    Boxes boxes, blocks;        // of the plates by place, and of kBlock places in a row
    std::vector<Rigid> over;    // across() of each side; empty when there are too many
  };
  struct FloatBox;
  struct Plate {
    int panel, first, count;
  };

  void make_plates(double clearance);
  double angle_at(int side, double time) const;
  void place_all(Sample& sample);
  void place_from(Sample& sample, int root, int barred);
  void place_plate(Sample& sample, int plate) const;
  void line_up();
  void bound_block(Sample& sample, int block) const;
  void find_blocks(std::span<const int> branch);
  void find_beyond();
  void move_branch(const Sample& sample, std::span<const int> branch, const Rigid& motion);
  void find_near(const Sample& sample);
  template <class Visit>
  bool visit_near(const Sample& sample, const FloatBox& box, Visit visit) const;
  void unjoin(std::span<const int> branch);
  void place_branch(Sample& sample, int side);
  void find_conflicts(int sample);
  void mark(std::span<const int> branch);
  Rigid moved_by(const Sample& sample, int side) const;
  Rigid pose_over(const Sample& sample, int side) const;  // the same as across() at its moment
  void find_over(Sample& sample) const;
  template <class Found>
  bool meet(const Sample& sample, std::span<const int> branch, int side, Found found);
  bool penetrating(const Sample& sample, int plate, const Vec3* corners, const Vec3& normal, int other) const;

  const PanelKit& kit_;
  FoldingLaw law_;
  double touch_, steepest_ = 0;
  std::vector<Vec3> shape_;  // corners of all plates in their panels' planes
  std::vector<Plate> plates_;
  std::vector<int> first_plate_;       // panels + 1
  std::vector<int> place_, plate_at_;  // plates in the order of a walk along the tree, so that blocks are small
  std::vector<Pose> side_frame_;       // of each side in its panel: origin at its start, x along it
  std::vector<Pose> beyond_;           // of each side with a twin: the twin's panel seen from the turned frame
  std::vector<int> side_panel_;
  std::vector<char> is_joined_;  // by side, both sides of a pair
  std::vector<Sample> samples_;
  std::vector<int> sample_order_;  // those that refuted a hanging lately come first
  std::vector<Conflict> conflicts_;
  std::vector<int> mark_;
  int stamp_ = 0, hung_since_lining_up_ = 0;
  long work_ = 0;
  // What conflicts_if_hung() found last, if it looked at every sample; hang() needs the same.
  struct Foreseen {
    int side = -1;
    std::vector<int> branch;
    std::vector<Conflict> conflicts;
  } foreseen_;
  std::vector<Vec3> moved_;                       // corners of the branch where it would hang
  std::vector<std::pair<int, int>> queue_;        // panel, side by which it was entered
  std::vector<int> touched_;                      // blocks that hold plates of the branch
  std::vector<int> near_;                         // places of plates of the rest close to the branch
  std::vector<std::pair<int, int>> near_blocks_;  // with some of them: block, end of its places in near_
};

}  // namespace plico
