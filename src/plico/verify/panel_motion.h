// Rigid panels that move over the times [0, 1]: all that the proof of collision freedom knows of a motion. What a
// polyline of fold angles means between its waypoints: in a tree, fold angles are linear in time (LinkageMotion); in a
// sheet with loops they cannot all be, and every panel moves by itself (sheet_motion.h).
#pragma once
#include <vector>

#include "plico/fold/folding_path.h"

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
// i, so it strays from its chord by at most an eighth of that, plus sum_i kink_i R_i. bend() is O(hinges on the chain).
class LinkageMotion : public PanelMotion {
 public:
  // Both must outlive the motion. Throws InvalidInput when the path does not fit the linkage.
  LinkageMotion(const Linkage& linkage, const FoldingPath& path);

  void place(double time, const std::vector<char>& wanted, std::vector<Pose>& poses) const override;
  void look_at(double start, double end, const std::vector<Pose>& at_start) override;
  double bend(int panel, int frame) const override;
  int frame_of(int panel_a, int panel_b) const override;
  void want(int panel, std::vector<char>& wanted) const override;
  double rounding() const override { return rounding_; }

 private:
  void configure(double time, Configuration& config) const;

  const Linkage& linkage_;
  const FoldingPath& path_;
  std::vector<int> depth_;
  std::vector<Vec3> center_, pivot_,
      axis_;                           // flat state, by panel: bounding sphere; a point and direction of its hinge
  std::vector<double> radius_, link_;  // by panel: of the sphere; from its hinge's pivot to its parent's
  double rounding_ = 0;

  const std::vector<Pose>* at_start_ = nullptr;
  std::vector<double> turn_, kink_, turn_from_root_;  // by panel: of its hinge; sums of turn_ along the chain
  mutable Configuration config_;
  Configuration start_config_, end_config_, inside_;
};

}  // namespace plico
