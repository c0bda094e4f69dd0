// The motion of a sheet whose creases form loops, as the proof judges it.
#pragma once
#include <vector>

#include "plico/verify/panel_motion.h"

namespace plico {

// How well loops hold together: at the waypoints as measured, between them as bounded.
struct LoopReport {
  int loops = 0;  // hinges that close one
  double residual =
      0;              // worst rotation across a loop hinge at a waypoint, radians: the panels' poses against its angle
  double tear = 0;    // farthest that an end of a loop hinge comes apart at a waypoint, units
  int waypoint = -1;  // of the worst residual
  int hinge = -1;     // of the worst residual
  double gap = 0;     // no hinge opens wider between waypoints, units; includes tear
  double gap_share = 0;                   // gap over the diagonal of the flat sheet
  double twist = 0;                       // nor turns farther from its axis and angle, radians; includes residual
  int gap_waypoint = -1, gap_hinge = -1;  // the gap is between this waypoint and the next, at this hinge
};

// At waypoints the panels stand where the fold angles put them, and the loops must close there. Were the fold angles
// linear in between, as in a tree, loops would drift apart along the chains, more in larger sheets. So every panel goes
// by itself from its pose at one waypoint to its pose at the next: its centre along a straight line, its rotation about
// one axis, both at constant speed. On the way a corner at distance r from the centre of a panel that turns by theta
// strays from its chord by at most r theta^2 / 8, and both panels of a hinge have the same chords. So no hinge, in the
// tree or closing a loop, opens by more than the sum of two such terms, however large the sheet. A fold angle that
// changes by more than 90 degrees in one step counts as a gap of its hinge's length: the panels may go the other way.
// O(waypoints * panels) memory.
class SheetMotion : public PanelMotion {
 public:
  // Both must outlive the motion. Throws InvalidInput when the path does not fit the linkage.
  SheetMotion(const Linkage& linkage, const FoldingPath& path);

  const LoopReport& loops() const { return loops_; }
  // How far a hinge may open between `waypoint` and the next; grows with the square of the step.
  double gap_after(int waypoint) const { return gaps_[waypoint]; }

  void place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const override;
  void look_at(double start, double end, const std::vector<Pose>& at_start) override;
  double bend(int panel, int frame) const override;
  int frame_of(int /*panel_a*/, int /*panel_b*/) const override { return -1; }
  void want(int panel, std::vector<char>& wanted) const override { wanted[panel] = 1; }
  double rounding() const override { return rounding_; }
  double split(double start, double end) const override;

 private:
  struct Stand {  // of a panel at a waypoint
    Eigen::Quaterniond turn;
    Vec3 center;
  };
  struct Moment {  // on the way from waypoint `before` to the next
    int before;
    double share;
  };

  Moment moment(double time) const;
  Stand stand(int panel, const Moment& moment) const;
  double stray(int panel) const;
  void measure_closing(int waypoint, const std::vector<Pose>& poses);
  void bound_gaps();

  const Linkage& linkage_;
  const FoldingPath& path_;
  std::vector<Vec3> center_;    // flat state, by panel
  std::vector<double> radius_;  // of the panel around it
  std::vector<std::vector<Stand>> stands_;
  std::vector<std::vector<double>> arcs_;  // theta^2 / 8 of each panel from a waypoint to the next
  std::vector<double> gaps_;
  LoopReport loops_;
  double rounding_ = 0;
  double start_ = 0, end_ = 1;  // what bend() speaks of
  Moment at_start_{0, 0}, at_end_{0, 1};
  int first_inside_ = 0, last_inside_ = -1;  // waypoints strictly inside
};

}  // namespace plico
