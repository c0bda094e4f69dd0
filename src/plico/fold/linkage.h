// Rigid panels joined at hinges: what every net, crease pattern and strip becomes before it moves. Kinematics,
// collision, proof, planners, viewer and exporters are written once, for linkages, and cannot tell which they hold.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/vec.h"
#include "plico/fold/crease_pattern.h"
#include "plico/fold/real_vertices.h"

namespace plico {

// All fold angles, one per hinge, radians, valley > 0 > mountain (R1); all zero is flat.
using Configuration = Eigen::VectorXd;

struct Hinge {
  int left = -1, right = -1;      // panels: `left` lies left of from -> to, seen from the front
  Vec3 from, to;                  // the axis in the flat state; z is its offset from the mid-plane
  double target = 0;              // fold angle at the goal
  double low = -kPi, high = kPi;  // limits of the fold angle: the one home of what the material allows
  // Of a thick hinge half the thickness t of its panels, else 0. Up to 90 degrees it turns about from -> to; beyond,
  // about the line in which the panels will touch: t/2 before from -> to, and t/2 above the mid-plane of the panel at
  // rest for valleys, below it for mountains. So its free length is t cos(a/2), then t sin(a/2) (eq. 6.1, read as R11).
  double roll = 0;
  int edge = -1, a = -1, b = -1;  // of the sheet that it came from, and its vertices; -1: of none
};

// The motion of one panel of a hinge, seen from the other, which carries it from flat to a fold angle.
Pose turn(const Hinge& hinge, double fold_angle, bool right_moves);

struct Linkage {
  std::vector<std::vector<Vec3>>
      panels;  // outlines in the flat state (z = 0), counter-clockwise seen from +z, the front
  std::vector<Hinge> hinges;
  double thickness = 0;  // of every panel, units: a prism from -thickness / 2 to thickness / 2 in z; 0 is a sheet

  // The tree along which panels are placed, roots first: `order` lists the panels; parent_hinge[p] leads from
  // parent_panel[p] to p and is -1 for a root. A hinge outside the tree closes a loop.
  std::vector<int> order, parent_panel, parent_hinge;
  std::vector<int> loop_hinges;   // hinges that are not in the tree, ascending
  std::vector<RealVertex> loops;  // of a thin sheet: what must close, as real_vertices() lists it; empty for trees

  // Pairs of sides that are glued at the goal: panel and side index (side i runs from outline[i] to outline[i + 1]).
  struct Seam {
    int panel_a, side_a, panel_b, side_b;
  };
  std::vector<Seam> seams;

  int num_panels() const { return static_cast<int>(panels.size()); }
  int num_hinges() const { return static_cast<int>(hinges.size()); }
  bool has_loops() const { return !loop_hinges.empty(); }
};

// The linkage of a flat sheet: one panel per face; a hinge per edge between two panels, in the order of the edges.
// `mate` (may be empty) has the glued edge of each edge or -1. The stationary panel of each part is the centre of its
// tree (shortest chains), or `base` for the part that holds it. Breadth-first tree, ties by id. O(n log n).
Linkage make_linkage(const CreasePattern& sheet, const std::vector<int>& mate = {}, int base = -1);

// The same linkage with panels that are `thickness` thick, and the axis of each hinge (all in the mid-plane when empty)
// moved by offset[h], which must lie within the panels: thickness / 2 is the front, -thickness / 2 the back. Throws
// InvalidOption otherwise.
Linkage thickened(Linkage linkage, double thickness, const std::vector<double>& offset = {});

// The same linkage with thick hinges (Hinge::roll), its square panels trimmed by `trim` on every side. Throws
// InvalidOption unless 0 < thickness < half the smallest side and thickness / 2 <= trim < half of it.
Linkage thick_hinged(Linkage linkage, double thickness, double trim);

// The hinge of each sheet edge, -1 for edges that are not hinges; the inverse order of make_linkage.
std::vector<int> hinge_of_edge(const CreasePattern& sheet);

Configuration flat(const Linkage& linkage);
Configuration goal(const Linkage& linkage);

// How much of the way from flat to the goal is behind `config`: 1 minus its distance to the goal over that of the flat
// state, both over the hinges that are to fold (target not 0); 1 when there are none. At most 1; below 0 beyond flat.
double share_of_way(const Linkage& linkage, const Configuration& config);

// The limits of all hinges, radians.
Configuration lower_limits(const Linkage& linkage);
Configuration upper_limits(const Linkage& linkage);

inline constexpr double kLimitRounding = 1e-6;  // radians, that an angle written to a file may lie beyond its limit

// A hinge whose angle in `config` lies beyond its limits by more than `slack` radians, -1 for none.
int hinge_beyond_limits(const Linkage& linkage, const Configuration& config, double slack = 1e-9);

// Throws InvalidInput "fold/limits" when there is one. `what` is the subject of the sentence: "the goal".
void require_within_limits(const Linkage& linkage, const Configuration& config, std::string_view what,
                           double slack = 1e-9);

// For messages: "crease 5 (vertices 2-3, near 1 0.5)" of the sheet, or "hinge 7 (panels 2-3)" of a linkage without; the
// real vertex "vertex 4 (1, 0.5)", "no vertex" for none.
std::string tell_hinge(const Linkage& linkage, int hinge);
std::string tell_vertex(const Linkage& linkage, int vertex);

// The rigid motion that carries each panel from the flat state to `config`, roots at rest (eq. 2.3, read as R3). Loops
// are not closed here: a foldable configuration agrees on them by itself. O(panels).
std::vector<Pose> folding_map(const Linkage& linkage, const Configuration& config);
void folding_map(const Linkage& linkage, const Configuration& config, std::vector<Pose>& poses);  // no allocation

// The part of each panel, 0..k-1: panels that hinges connect, however far, are one part. O(panels).
std::vector<int> parts(const Linkage& linkage);

double mean_side_length(const Linkage& linkage);   // units; a hinge counts once for each of its panels
double default_clearance(const Linkage& linkage);  // 1e-3 of the mean side length: see motion/collision.h

// Number of hinges on the longest chain from a root.
int chain_depth(const Linkage& linkage);

}  // namespace plico
