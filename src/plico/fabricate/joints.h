// Facets that are glued face to face: what is drawn on both so that they can be found and turned the right way.
#pragma once
#include <string>
#include <vector>

#include "plico/fabricate/place.h"
#include "plico/fold/page_layout.h"
#include "plico/font/font.h"

namespace plico {

// How pieces hold on to each other where their facets meet: glued; by a paper rivet through a hole in both, so that
// they can be turned; or in a way of which the pages say nothing.
enum class JointKind { Glue, Rivet, None };

// One side of a joint: where a facet of another piece meets this one.
struct JointFacet {
  int panel = -1;             // of the net
  std::vector<Vec2> polygon;  // where the pieces touch, on that panel of the net, in the net's unit; convex
  int up = 0;                 // the corner that lies on the same point of both sides
  std::string text;           // as "to B: 3", the same number on both
};

inline constexpr double kRivet = 4;  // millimetres, the hole

// Writes the text of each facet into its polygon, as large as fits (10 to 4 pt), beside the hole if there is one,
// before other labels are placed. Returns how many did not fit. `placed` has the placement of every part.
int write_joints(PageLayout& layout, const std::vector<JointFacet>& facets, JointKind kind,
                 const std::vector<int>& part_of_panel, const std::vector<Placement>& placed, const Font& font);

// Draws the polygon of each facet and a stroke from its corner `up` towards the middle, the same on both sides, and the
// hole for the rivet at its centroid. Returns for how many facets the hole is too large.
int draw_joints(PageLayout& layout, const std::vector<JointFacet>& facets, JointKind kind,
                const std::vector<int>& part_of_panel, const std::vector<Placement>& placed);

}  // namespace plico
