// How far apart panels are at a state, and how that changes as hinges turn: what a search needs to slide along a
// contact instead of ending there.
#pragma once
#include "plico/motion/collision.h"

namespace plico {

// One place where two thin panels are near each other: a corner before the plane of the other panel, or two sides.
struct Contact {
  PanelPair panels;
  double apart = 0;     // units, along the direction that takes the panels apart best; below 0 they penetrate
  Configuration slope;  // of `apart` by each fold angle, units a radian, the direction held
};

// Of each of `pairs`, the contacts of plates (shrunk as `plates` is) that are less than `reach` apart. A side against a
// side is one contact, a panel that faces another has one a corner. O(pairs * (corners^3 + chain depth)).
std::vector<Contact> contacts(const Linkage& linkage, const Plates& plates, const Configuration& config,
                              const std::vector<PanelPair>& pairs, double reach);

}  // namespace plico
