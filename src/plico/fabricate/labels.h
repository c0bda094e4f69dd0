// Edge ids: a short text on both edges of a seam, where it can be read: its number, and before it the part that the
// other edge is on, when that is another one.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/page_layout.h"
#include "plico/font/font.h"

namespace plico {

struct LabelOptions {
  bool edge_ids = true;
  bool part_names = true;  // a large letter on each part, and its name, when there are several
  double size_pt = 7;      // wanted size of an edge id, in [min_pt, 24]
  double smallest_pt = 4;  // an id is made smaller down to 5, or to this where there is no other way, in [3, size_pt]
};
void check(const LabelOptions& options);  // throws InvalidOption naming field, value and range

struct LabelReport {
  int placed = 0;   // edge ids at their edge
  int leaders = 0;  // edge ids beside the part, with a leader line
  int omitted = 0;  // edges whose id fits nowhere
};

// Adds labels to the placed parts of `layout`. seam_name has the id of each sheet edge, empty for none. A label lies
// inside its panel or on its tab, or outside on free paper with a leader line; labels share no point with each other,
// with marks, or with the margin. Once the run is over no more ids are written, or counted. O(n).
LabelReport add_labels(PageLayout& layout, const std::vector<std::string>& seam_name, const Font& font,
                       const LabelOptions& options, const Run& run = {});

}  // namespace plico
