// The hinges that a peel has open at a time: what hangs on them, and whether it keeps clear of what stands and of
// itself.
#pragma once
#include <array>
#include <vector>

#include "plico/stack/peel_bodies.h"

namespace plico {

constexpr int kMostOpen = 4;
using OpenAngles = std::array<double, kMostOpen>;  // radians; those beyond the window's count are 0

class PeelWindow {
 public:
  // The hinges first .. first + count - 1 turn; panels 0 .. first stand.
  PeelWindow(const PeelBodies& bodies, int first, int count);

  int first() const { return first_; }
  int count() const { return count_; }

  bool free_at(const OpenAngles& angles) const;
  // Some moments of the straight way between two states, so many degrees apart.
  bool free_at_samples(const OpenAngles& from, const OpenAngles& to, double apart) const;
  // Every moment of the straight way between two states, by bisection: the gap of two boxes at the middle of an
  // interval, in some direction, against how far they can move in it. False also when that cannot be decided.
  bool free_between(const OpenAngles& from, const OpenAngles& to, long& intervals) const;

 private:
  // Moves with the first `depth` hinges; `local` is flat. A panel beside a hinge, or a piece of the tower.
  struct Body {
    int panel, depth;
    bool is_tower;
    OrientedBox local;
  };
  struct Placed {
    std::vector<OrientedBox> box;
    std::array<Vec3, kMostOpen> axis, point;  // of the hinges, in the world
  };
  // Of a motion: its middle, where everything is then, how far every hinge turns to either side, and whether its axis
  // changes on the way.
  struct Interval {
    Placed at;
    OpenAngles half_turn{};
    std::array<bool, kMostOpen> changes_axis{};
  };
  // The turns that carry a body while an interval lasts, as another sees it, the innermost first.
  struct Turning {
    Vec3 axis, point;
    double half, sine, sag;  // radians to either side of the middle of the interval; its sine, 1 - its cosine
    double loose;  // how far what it turns may be from where it is in the middle, by the turns before and its own axes
  };
  struct Motion {
    int count = 0;
    std::array<Turning, kMostOpen> turns;
    OrientedBox body;                             // in the middle of the interval
    double total = 0;                             // that it moves anything of the body by, at most
    double against(const Vec3& direction) const;  // the corners never get lower than this in the direction
  };

  // A mover, and what it may meet: a panel that stands, or another mover.
  struct Pair {
    int mover, other;
    bool stands;
  };

  void place(const OpenAngles& angles, Placed& placed) const;
  Interval interval(const OpenAngles& from, const OpenAngles& to) const;
  Motion motion(int mover, int below, const Interval& interval) const;
  // `apart` is the gap of the two where they are.
  bool stays_clear(const OrientedBox& mover, const OrientedBox& other, double apart, const Motion& motion) const;
  int last_standing(int mover) const;
  bool is_hit(const Placed& placed) const;
  bool is_clear(const Interval& interval) const;
  std::vector<Pair> near_pairs(const Interval& interval) const;
  bool halve_near(const OpenAngles& from, const OpenAngles& to, const std::vector<Pair>& pairs, int depth,
                  long& intervals, long most) const;
  bool halve(const OpenAngles& from, const OpenAngles& to, int depth, long& intervals, long most) const;

  const PeelBodies& bodies_;
  int first_, count_;
  std::vector<Body> movers_;
  std::vector<std::pair<int, int>> inner_;  // movers that may meet each other, the deeper one first
};

}  // namespace plico
