// One segment of a chain's motion, for its judge: what moves against what, how fast at most, and spheres around what
// rests. Hinges that rest cut the chain into rigid groups; a pile within a group is one block.
#pragma once
#include <cstddef>
#include <vector>

#include "plico/fold/linkage.h"
#include "plico/geom/oriented_box.h"

namespace plico {

// Where the panels of a chain are (hinge i between the panels i and i + 1, panel 0 at rest). From one state to the next
// only what hangs on a hinge that turned is placed anew.
class ChainPoses {
 public:
  explicit ChainPoses(const Linkage& chain);

  void fold(const Configuration& config);
  const std::vector<Pose>& all() const { return poses_; }

 private:
  const Linkage& chain_;
  Configuration config_;     // empty before the first
  std::vector<Pose> turns_;  // of panel i + 1 as panel i sees it
  std::vector<Pose> poses_;
};

// A panel, or a pile of them, where it is at the start of a segment.
struct ChainBlock {
  int group = 0;
  int first = 0, last = 0;  // panels
  OrientedBox box;
  double radius = 0;
};

class ChainSegment {
 public:
  // Around some blocks of one group that follow each other; halved down to single ones.
  struct Sphere {
    Vec3 center = Vec3::Zero();
    double radius = 0;
    std::size_t first = 0;  // of a leaf: its block
    std::size_t left = 0;   // else: the first of its two halves, the other one is next; 0 in a leaf
    bool is_leaf() const { return left == 0; }
  };

  // `start` are the poses at `from`. Faces move inwards by `air` thicknesses.
  ChainSegment(const Linkage& chain, const std::vector<Pose>& start, const Configuration& from, const Configuration& to,
               double air);

  const std::vector<ChainBlock>& blocks() const { return blocks_; }
  const std::vector<Sphere>& spheres(int group) const { return spheres_[group]; }  // the first holds all

  // Of two single panels at a hinge that moves: the hinge keeps them apart.
  bool are_mates(const ChainBlock& a, const ChainBlock& b) const;

  // Most speed of a point of `b` as the earlier group sees it, lengths per segment.
  double speed(int group, const ChainBlock& b) const;

  // Times in (0, 1) at which a thick hinge between the groups comes to turn about another axis (+-90 degrees),
  // ascending.
  std::vector<double> changes_of_axis(int a, int b) const;

  // A hinge that turns about a line.
  struct Turn {
    Vec3 point, rate;  // of the line; along it, radians per segment
  };
  struct Turns {
    std::vector<Turn> turns;  // of the hinges between the groups, from `a` on
    Pose pose;                // as moved() has it
  };
  // What turns group `b`, as the earlier group `a` sees it, from `time` until `end`, within which no axis changes.
  Turns turns(int a, int b, double time, double end) const;

  // The motion of group `b`, as the earlier group `a` sees it, from the start of the segment to `time` in [0, 1].
  Pose moved(int a, int b, double time) const;

 private:
  double angle(int hinge, double time) const { return from_[hinge] + time * (to_[hinge] - from_[hinge]); }
  Pose before_turning(int a, int m, const Pose& now) const;
  int num_moving() const { return static_cast<int>(moving_.size()); }
  void add_group(int group, int first, int last);
  void add_block(int group, int first, int last);
  void add_sphere(std::vector<Sphere>& spheres, std::size_t at, std::size_t from, std::size_t to) const;
  bool is_piled(int first, int next) const;
  Vec3 middle(int panel) const { return (chain_.panels[panel][0] + chain_.panels[panel][2]) / 2; }
  Vec3 center(int panel) const { return start_[panel] * middle(panel); }
  double side() const { return (chain_.panels[0][1] - chain_.panels[0][0]).norm(); }

  const Linkage& chain_;
  const std::vector<Pose>& start_;
  const Configuration &from_, &to_;
  const double air_;
  std::vector<int> moving_;  // hinges
  std::vector<ChainBlock> blocks_;
  std::vector<std::vector<Sphere>> spheres_;  // a row a group
};

}  // namespace plico
