// Is a layout sound: nothing overlaps, everything is on its page, every tab fits the panel it is glued under?
#pragma once
#include <string>
#include <vector>

#include "plico/fold/page_layout.h"

namespace plico {

struct LayoutVerdict {
  long overlaps = 0;      // pairs of panels and tabs on one page that share an interior point, exact (verify/overlap.h)
  int off_page = 0;       // panels and tabs that reach into the margin
  int loose_tabs = 0;     // tabs whose base is not on the edge it claims
  int misfit_tabs = 0;    // tabs that, turned over their seam, stick out of the panel they are glued under
  int open_outlines = 0;  // parts whose outlines do not enclose the area of their panels and tabs
  std::vector<std::string> problems;  // one sentence each, the first 20

  bool sound() const { return overlaps + off_page + loose_tabs + misfit_tabs + open_outlines == 0; }
};

// Judges from the layout alone. Overlap is decided exactly; the other claims up to 1e-6 mm. O(n log n).
LayoutVerdict verify_layout(const PageLayout& layout);

}  // namespace plico
