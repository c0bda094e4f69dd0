// What hands have to do with the printed pages, whether they can, and at which size they could.
#pragma once
#include <optional>

#include "plico/base/run.h"
#include "plico/fabricate/fabricate.h"

namespace plico {

inline constexpr double kSmallEdge = 5;  // millimetres

// Edges of the printed net, those to fold and those to glue, each once.
struct HandWork {
  int edges = 0, small = 0;  // in all, and shorter than kSmallEdge
  int ids = 0, omitted = 0;  // of edges, asked for, and left out where they did not fit
  int seams = 0, bare = 0;   // to glue, and those without a tab for want of room
  // Most edges are short, or more than a tenth of the ids or a third of the tabs is missing.
  bool too_small() const { return 2 * small > edges || 10 * omitted > ids || 3 * bare > seams; }
};
HandWork hand_work(const Unfolding& net, const LayoutReport& report);

// The same net printed larger, cut where it does not fit a page.
struct LargerPages {
  double longest_mm = 0;  // of the model
  int pages = 0;
  HandWork work;  // no longer too small
};

// The smallest size, of some up to four times the one of `report`, at which the work is not too small: laid out, not
// guessed. None when there is none, a panel is larger than a page, or the run ends before. At most six layouts.
std::optional<LargerPages> larger_pages(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options,
                                        const LayoutReport& report, const Run& run);

}  // namespace plico
