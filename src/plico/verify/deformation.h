// How much the paper of a motion is deformed whose loops do not quite close.
#pragma once
#include "plico/fold/folding_path.h"

namespace plico {

// The dissertation's measure ([Xi17] eq. 2.1, read as R2): each vertex is at the mean of the places that its panels
// give it, and an edge is deformed by its change of length over its length.
struct Deformation {
  double worst = 0;   // share of an edge's length, over all waypoints
  int waypoint = -1;  // where; -1 when nothing changes
  int edge = -1;      // which
};
Deformation measure_deformation(const CreasePattern& sheet, const Linkage& linkage, const FoldingPath& path);

inline constexpr double kMostDeformation = 0.1;  // that may be asked for: beyond it a proof says nothing about paper

// The clearance at which a motion is proven that may be deformed by `deformation`: `clearance`, a thousandth of the
// mean side or what was asked for, and that share of the mean side on top of it.
double deformed_clearance(double clearance, double deformation);

// What a proof takes for closed then: any turn, since the bound is on lengths and on the gap of hinges.
inline constexpr double kOpenOnPurpose = kPi;

}  // namespace plico
