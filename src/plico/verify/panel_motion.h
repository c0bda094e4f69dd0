// Rigid panels that move over the times [0, 1]: all that the proof of collision freedom knows of a motion. What a
// polyline of fold angles means between its waypoints: in a tree, fold angles are linear in time (LinkageMotion); in a
// sheet with loops they cannot all be, and every panel moves by itself (sheet_motion.h).
#pragma once
#include <vector>

#include "plico/fold/folding_path.h"
#include "plico/verify/ancestry.h"

namespace plico {

class PanelMotion {
 public:
  virtual ~PanelMotion() = default;

  // Poses at `time` of the panels that are `wanted` (all when empty); `poses` has one entry per panel.
  virtual void place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const = 0;

  // Chooses the interval that bend() speaks of; `at_start` are the poses at its start.
  virtual void look_at(double start, double end, const std::vector<Pose>& at_start) = 0;

  // How far any point of `panel`, seen from the panel `frame` (-1: from the world), strays during the interval from the
  // straight line that it would run, at constant speed, from where it is at the start to where it is at the end. An
  // upper bound, never NaN. With a bound V on the speed, V * (end - start) / 2 will do; bounds that shrink with the
  // square of the interval make the proof fast.
  virtual double bend(int panel, int frame) const = 0;

  // The panel from which both panels are seen to move least: the last panel common to their chains; -1 for the world.
  virtual int frame_of(int panel_a, int panel_b) const = 0;

  // Marks `panel` and every panel whose pose place() or bend() needs for it.
  virtual void want(int panel, std::vector<char>& wanted) const = 0;

  // Bound on the error of a placed corner by rounding, units.
  virtual double rounding() const = 0;

  // Where to halve an interval: a moment strictly inside it, at a waypoint if there is one.
  virtual double split(double start, double end) const { return start + (end - start) / 2; }
};

// Throws InvalidInput when the path does not fit the linkage: waypoints from time 0 to time 1, one finite angle a
// hinge.
void check_path(const Linkage& linkage, const FoldingPath& path);

// A linkage along a polyline of configurations. On an interval every fold angle is a chord (linear) plus at most its
// kink (0 without a waypoint inside). A point x at the end of hinges i = 1..k that turn by D_i along their chords has
// |x''| <= sum_i sum_j D_i D_j R_max(i,j) per interval squared, with R_i a bound on its distance from the axis of hinge
// i, so it strays from its chord by at most an eighth of that, plus sum_i kink_i R_i. bend() is O(hinges on the
// chain) the first time a panel is asked about on an interval, then O(1) for frames on that stretch. From the world, a
// panel takes its bound from that of its anchor, a panel a few hinges up: O(a sixteenth of the chain) on average.
class LinkageMotion : public PanelMotion {
 public:
  // Both must outlive the motion. Throws InvalidInput when the path does not fit the linkage.
  LinkageMotion(const Linkage& linkage, const FoldingPath& path);

  void place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const override;
  void look_at(double start, double end, const std::vector<Pose>& at_start) override;
  double bend(int panel, int frame) const override;
  int frame_of(int panel_a, int panel_b) const override { return ancestry_.common(panel_a, panel_b); }
  void want(int panel, std::vector<char>& wanted) const override;
  double rounding() const override { return rounding_; }

 private:
  // A panel and the hinge on which it hangs.
  struct Link {
    Vec3 axis_now, pivot_now;   // in the world at the start of the interval, valid when seen_at is the current look
    double turn = 0, kink = 0;  // of the hinge on the interval
    double slip = 0;            // how far points move with the axis' change, when it is inside the interval
    double axes = 0;            // distance of the axes of a thick hinge
    double length = 0;          // from its hinge's pivot to its parent's
    int parent = -1, anchor = -1;
    long seen_at = -1;
    Vec3 center = Vec3::Zero(), pivot = Vec3::Zero(), axis = Vec3::UnitX();  // flat: bounding sphere; point, direction
    double radius = 0;                                                       // of the sphere
  };
  // Over the hinges from a panel up to one of them: of turn, kink and reach * turn; what bend() takes off again; how
  // far the panel travels.
  struct Sums {
    double turn = 0, kink = 0, reach_turn = 0, less = 0, travel = 0;
  };
  // What one climb from a panel toward the root has gathered.
  struct Chain {
    std::vector<Sums> sums;  // one entry per hinge passed
    long seen_at = -1;
    int next = -1;               // panel whose hinge is passed next
    double straight = 0;         // from the next hinge to the panel's farthest point, chain stretched
    Vec3 center = Vec3::Zero();  // of the panel in the world at the start
    void climb(const Link& link, double radius);
  };
  // A panel seen from another one, or from the world.
  struct View {
    double bend = 0;
    double turn = 0;    // over the hinges between them
    double weight = 0;  // what the bend grows by when it reaches farther from all of them by 1
  };
  struct WorldView {
    View view;
    long seen_at = -1;
  };
  void configure(double time, Configuration& config) const;
  const Link& seen(int panel) const;
  void begin(Chain& chain, int panel) const;
  const Sums& climb(Chain& chain, int panel, int hinges) const;
  View view(Chain& chain, int panel, int hinges) const;
  const View& from_world(int anchor) const;

  const Linkage& linkage_;
  const FoldingPath& path_;
  mutable std::vector<Link> links_;             // by panel
  mutable std::vector<Chain> chains_;           // by panel
  mutable std::vector<WorldView> world_views_;  // by panel, of anchors
  mutable Chain to_world_;                      // of one anchor
  Ancestry ancestry_;
  double rounding_ = 0;
  const std::vector<Pose>* at_start_ = nullptr;
  long look_ = 0;
  mutable Configuration config_;
  Configuration start_config_, end_config_, inside_;
};

}  // namespace plico
