// Edge ids: the same number on both edges of a seam, where it can be read.
#pragma once
#include <vector>

#include "plico/fold/page_layout.h"
#include "plico/font/font.h"

namespace plico {

struct LabelOptions {
  bool edge_ids = true;
  bool part_names = true;  // a large letter on each part when there are several
  double size_pt = 7;      // wanted size of an edge id, in [min_pt, 24]
  double smallest_pt = 4;  // an id is made smaller down to this, in [3, size_pt]
};
void check(const LabelOptions& options);  // throws InvalidOption naming field, value and range

struct LabelReport {
  int placed = 0;   // edge ids at their edge
  int leaders = 0;  // edge ids beside the part, with a leader line
  int omitted = 0;  // edges whose id fits nowhere
};

// Adds labels to the placed parts of `layout`. seam_name has the id of each sheet edge, empty for none. A label lies
// inside its panel or on its tab, or outside on free paper with a leader line; labels share no point with each other,
// with marks, or with the margin. O(n).
LabelReport add_labels(PageLayout& layout, const std::vector<std::string>& seam_name, const Font& font,
                       const LabelOptions& options);

}  // namespace plico
