// Glue tabs: a trapezoid on one of the two sides of every seam, where there is room for it.
#pragma once
#include <array>
#include <vector>

#include "plico/fabricate/net_sides.h"

namespace plico {

// Which of the two edges of a seam carries its tab. First and Second are in the order of walking around the parts, so
// First puts all tabs of a seam between two parts on the earlier one.
enum class TabSide { Auto, Alternate, First, Second, Both, None };

struct TabOptions {
  TabSide side = TabSide::Auto;  // Auto: the smaller panel, unless only the other one has room
  double depth = 5;              // millimetres, in [1, 50]
  double angle = radians(45);    // between base and slanted side, radians, in [radians(20), radians(80)]
  double shortest_edge = 3;      // shorter edges get no tab, millimetres
};
void check(const TabOptions& options);  // throws InvalidOption naming field, value and range

struct NetTab {
  int edge = -1, mate = -1;
  std::array<Vec2, 4> corners;  // a, b, tip beside b, tip beside a: clockwise
};

struct Tabs {
  std::vector<NetTab> tabs;  // by edge
  int seams = 0;             // of which a tab was wanted
  int full = 0;              // tabs of full depth and angle
  int shrunk = 0;            // tabs less deep, less steep or shorter than their edge, so that they fit
  int moved = 0;             // seams whose tab is on the other side than the rule says
  int omitted = 0;           // seams without a tab because none fits
  int short_seams = 0;       // seams shorter than shortest_edge
  std::vector<int> without;  // first edges of the seams without a tab
};

// Tabs for a net in millimetres. No tab meets a panel or another tab of its part, and each, turned over its seam, lies
// inside the panel it is glued under; both decided exactly, with a little clearance. Remedies, in this order: a smaller
// tab, the other side of the seam, a much smaller tab, none. O(n) for nets of bounded crowding.
Tabs make_tabs(const NetSides& sides, const std::vector<std::vector<std::vector<int>>>& outlines,
               const TabOptions& options);

}  // namespace plico
