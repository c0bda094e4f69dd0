// A block of a chain on its way, as the blocks of an earlier rigid group see it while a segment lasts; for the judge.
#pragma once
#include <array>
#include <vector>

#include "plico/verify/chain_segment.h"

namespace plico {

class ChainApproach {
 public:
  // The block belongs to a later group than `seen_by`.
  ChainApproach(const ChainSegment& segment, int seen_by, const ChainBlock& block);

  const ChainSegment& segment() const { return segment_; }
  const ChainBlock& block() const { return block_; }
  int seen_by() const { return seen_by_; }
  double speed() const { return speed_; }  // of a point of the block, lengths per segment, at most

  OrientedBox at(double time) const;

  // Until when the block is apart from a resting box, at least, if it is at `time`; at most until the next hinge turns
  // about another axis. In a direction d that tells them apart a corner x of the block is d.x + s d.x' - A s^2 / 2 or
  // more away after s: x' is its velocity, A the most acceleration in that direction. So what moves along the side of a
  // box, or turns about an edge of it, is told to be apart for long, however near it is.
  double apart_until(const OrientedBox& box, double time) const;

  // When a hinge next turns about another axis, or the end.
  double next_change(double time) const;

 private:
  // Of a corner of the block.
  struct Corner {
    Vec3 at, velocity;
    double acceleration;  // at most, in any direction
  };
  struct Corners {
    std::array<Corner, 8> all;
    Vec3 axis;  // of all turns when they have one
    bool has_one_axis;
  };
  Corners corners(double time) const;
  double apart_for(const Corners& corners, const OrientedBox& box, const Vec3& direction) const;

  const ChainSegment& segment_;
  const int seen_by_;
  const ChainBlock& block_;
  const double speed_;
  std::vector<double> changes_;  // ascending
};

}  // namespace plico
